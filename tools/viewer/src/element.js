// SPDX-License-Identifier: BSD-3-Clause

/** A new element. Strings become text, never markup: names in files are not ours. */
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

export const byId = (id) => document.getElementById(id);
