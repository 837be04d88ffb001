// SPDX-License-Identifier: BSD-3-Clause

/** The value of a colour of page.css in the theme of the moment, for what CSS does not draw. */
export const themeColor = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

const dark = window.matchMedia('(prefers-color-scheme: dark)');

export const isDark = () => dark.matches;

export const onThemeChange = (react) => dark.addEventListener('change', react);
