// The joint that the page shows: a joint file, its changes and its measured surfaces; undo; and the same in the address.

const MOST_STEPS = 200;

async function through(stream, bytes) {
  const piped = new Blob([bytes]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(piped).arrayBuffer());
}

/** State as text for the address: compressed, in letters that need no escapes. */
export async function packed(state) {
  const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(JSON.stringify(state)));
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** The state of an address, or null if it contains none that can be read. */
export async function unpacked(text) {
  try {
    const raw = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = Uint8Array.from(raw, (letter) => letter.charCodeAt(0));
    const found = JSON.parse(new TextDecoder().decode(await through(new DecompressionStream("deflate-raw"), bytes)));
    const plain = typeof found.toml === "string" && typeof found.name === "string" && typeof found.changes === "object";
    const surfaces = Array.isArray(found.surfaces) ? found.surfaces : [];
    return plain && found.changes !== null ? { name: found.name, toml: found.toml, changes: found.changes, surfaces } : null;
  } catch {
    return null;
  }
}

/** States one after the other, with a way back and forth. */
export class History {
  constructor(state) {
    this.states = [state];
    this.place = 0;
    this.lastPath = null;
  }

  get state() {
    return this.states[this.place];
  }

  /** A new state; moves of one slider in a row are one step. */
  add(state, path = null) {
    const same = path !== null && path === this.lastPath && this.place === this.states.length - 1 && this.place > 0;
    this.states.length = this.place + 1;
    if (same) this.states[this.place] = state;
    else this.states.push(state);
    if (this.states.length > MOST_STEPS) this.states.shift();
    this.place = this.states.length - 1;
    this.lastPath = path;
  }

  /** The next change of the same value is a step of its own. */
  settle() {
    this.lastPath = null;
  }

  move(steps) {
    const wanted = this.place + steps;
    if (wanted < 0 || wanted >= this.states.length) return false;
    this.place = wanted;
    this.lastPath = null;
    return true;
  }

  get canUndo() {
    return this.place > 0;
  }

  get canRedo() {
    return this.place < this.states.length - 1;
  }
}
