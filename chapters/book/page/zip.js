// zip.js - the archive of answers: a zip without compression, and reading one that may be compressed.

const table = Uint32Array.from({ length: 256 }, (_, n) => {
    for (let k = 0; k < 8; k++)
        n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
    return n;
});

export function crc32(bytes) {
    let crc = 0xffffffff;
    for (const byte of bytes)
        crc = table[(crc ^ byte) & 255] ^ (crc >>> 8);
    return (crc ^ 0xffffffff) >>> 0;
}

/** Time and date as MS-DOS counts them. */
function dosTime(when) {
    const time = (when.getHours() << 11) | (when.getMinutes() << 5) | (when.getSeconds() >> 1);
    const date = ((when.getFullYear() - 1980) << 9) | ((when.getMonth() + 1) << 5) | when.getDate();
    return [time, date];
}

const LOCAL = 0x04034b50, CENTRAL = 0x02014b50, END = 0x06054b50, UTF8 = 1 << 11;

/**
 * @param {{name: string, bytes: Uint8Array}[]} files
 * @returns {Uint8Array}
 */
export function makeZip(files, when = new Date()) {
    const parts = [], central = [];
    const [time, date] = dosTime(when);
    let offset = 0;
    for (const { name, bytes } of files) {
        const path = new TextEncoder().encode(name);
        const facts = (view, at) => {
            view.setUint16(at, 20, true);
            view.setUint16(at + 2, UTF8, true);
            view.setUint16(at + 6, time, true);
            view.setUint16(at + 8, date, true);
            view.setUint32(at + 10, crc32(bytes), true);
            view.setUint32(at + 14, bytes.length, true);
            view.setUint32(at + 18, bytes.length, true);
            view.setUint16(at + 22, path.length, true);
        };
        const local = new DataView(new ArrayBuffer(30));
        local.setUint32(0, LOCAL, true);
        facts(local, 4);
        const entry = new DataView(new ArrayBuffer(46));
        entry.setUint32(0, CENTRAL, true);
        entry.setUint16(4, 0x031e, true); // made on Unix
        facts(entry, 6);
        entry.setUint32(38, 0o100644 * 0x10000, true);
        entry.setUint32(42, offset, true);
        parts.push(new Uint8Array(local.buffer), path, bytes);
        central.push(new Uint8Array(entry.buffer), path);
        offset += 30 + path.length + bytes.length;
    }
    const length = central.reduce((sum, part) => sum + part.length, 0);
    const end = new DataView(new ArrayBuffer(22));
    end.setUint32(0, END, true);
    end.setUint16(8, files.length, true);
    end.setUint16(10, files.length, true);
    end.setUint32(12, length, true);
    end.setUint32(16, offset, true);
    const all = [...parts, ...central, new Uint8Array(end.buffer)];
    const zip = new Uint8Array(offset + length + 22);
    let at = 0;
    for (const part of all) {
        zip.set(part, at);
        at += part.length;
    }
    return zip;
}

async function inflate(bytes) {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

/**
 * @param {Uint8Array} bytes
 * @param {(name: string) => boolean} wanted
 * @returns {Promise<{name: string, bytes: Uint8Array}[]>}
 */
export async function readZip(bytes, wanted = () => true) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    let end = bytes.length - 22;
    while (end >= 0 && view.getUint32(end, true) !== END)
        end--;
    if (end < 0)
        throw new Error("this is not a zip archive");
    const files = [];
    let at = view.getUint32(end + 16, true);
    for (let left = view.getUint16(end + 10, true); left > 0; left--) {
        if (at + 46 > bytes.length || view.getUint32(at, true) !== CENTRAL)
            throw new Error("this archive is damaged");
        const method = view.getUint16(at + 10, true), crc = view.getUint32(at + 16, true), size = view.getUint32(at + 20, true);
        const nameLength = view.getUint16(at + 28, true), local = view.getUint32(at + 42, true);
        const name = new TextDecoder().decode(bytes.subarray(at + 46, at + 46 + nameLength));
        if (wanted(name)) {
            const start = local + 30 + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
            const stored = bytes.subarray(start, start + size);
            if (method !== 0 && method !== 8)
                throw new Error(`${name} is compressed in a way that this page cannot read`);
            const content = method === 8 ? await inflate(stored) : stored;
            if (crc32(content) !== crc)
                throw new Error(`${name} is damaged in this archive`);
            files.push({ name, bytes: content });
        }
        at += 46 + nameLength + view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
    }
    return files;
}
