// slips.js - slips of the pen in a C text, as students make them: something left out, doubled, exchanged, misspelt.

const tokens = text => text.match(/\/\/[^\n]*|\/\*[^]*?\*\/|"(?:\\.|[^"\\\n])*"|[A-Za-z_]\w*|[\d.]+\w*|[-+*/%<>=!&|^]+|\s+|[^]/g);
const others = [
  'int', 'double', ';', '(', ')', '{', '}', ',', '=', '==', '*', '&', '.', '->', 'vec3', 'x', 'i', '0', '1.5',
  'return', 'if', 'else', 'for', 'while', 'sqrt', 'static', 'const', 'struct', '"text"', '!', '-', '+', '/', '%', '<', '&&', '[', ']',
  'NULL', 'void', 'float', 'char', "'c'", '?', ':', 'sizeof', 'break', 'switch', 'case', 'printf', 'unsigned', '++', '+=', '#', '\\', '@'];

/**
 * @param {number} state where its random numbers begin
 * @returns {(text: string) => string} the text with a slip
 */
export function slips(state) {
  const random = most => {
    state = Math.imul(state, 1664525) + 1013904223 >>> 0;
    return Math.floor(state / 2 ** 32 * most);
  };
  return text => {
    const all = tokens(text), count = 1 + (random(4) === 0);
    for (let i = 0; i < count; i++) {
      let at = random(all.length);
      for (let tries = 0; tries < 20 && /^(\s|\/[/*])/.test(all[at]); tries++) at = random(all.length);
      const token = all[at], other = random(all.length);
      const how = random(8);
      if (how <= 1) all[at] = '';
      else if (how === 2) all[at] = token + token;
      else if (how === 3) [all[at], all[other]] = [all[other], token];
      else if (how === 4) all[at] = others[random(others.length)];
      else if (how === 5) all[at] = `${others[random(others.length)]} ${token}`;
      else if (how === 6) all[at] = token.slice(0, random(token.length)) + token.slice(1 + random(token.length));
      else if (/^\w{2}/.test(token)) all[at] = random(2) ? token.toUpperCase() : `${token[1]}${token[0]}${token.slice(2)}`;
      else all[at] = all[other];
    }
    return all.join('');
  };
}
