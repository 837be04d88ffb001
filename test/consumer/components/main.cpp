// SPDX-License-Identifier: BSD-3-Clause
bool works();

int main() {
  return works() ? 0 : 1;
}
