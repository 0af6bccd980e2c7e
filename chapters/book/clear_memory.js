// clear_memory.js - zeros in the memory of a program that runs again and again. A browser takes a page of memory from the
// system when it is first written, also if that writes zeros, and never gives it back. So pages that are still empty are
// only read.
export const PAGE = 1 << 16;

/**
 * @param {ArrayBuffer} buffer
 * @param {number} page
 */
export function isEmpty(buffer, page) {
  const words = new Int32Array(buffer, page * PAGE, PAGE / 4);
  for (let i = 0; i < words.length; i += 8)
    if (words[i] | words[i + 1] | words[i + 2] | words[i + 3] | words[i + 4] | words[i + 5] | words[i + 6] | words[i + 7]) return false;
  return true;
}

/** Zeros from one page to another. */
export function clear(buffer, from, to) {
  for (let page = from; page < to; page++)
    if (!isEmpty(buffer, page)) new Uint8Array(buffer, page * PAGE, PAGE).fill(0);
}
