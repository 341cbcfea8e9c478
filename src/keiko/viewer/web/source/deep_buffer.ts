/** One message of keiko-deep/1: some rows of a picture. */
export interface Pass {
  width: number;
  height: number;
  first: number;
  step: number;
  samples: Float32Array; // eight numbers a pixel
  bounces: DataView;     // 36 bytes each
}

const header = 32, sampleBytes = 32;
export const bounceBytes = 36;
const magic = "KEIKOD1\n";

/** Bytes of the message that begins with a header. */
function sizeOf(view: DataView): number {
  return header + view.getUint32(24, true) * sampleBytes + view.getUint32(28, true) * bounceBytes;
}

function passOf(bytes: Uint8Array): Pass {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const samples = view.getUint32(24, true);
  const end = header + samples * sampleBytes;
  return {
    width: view.getUint32(8, true), height: view.getUint32(12, true),
    first: view.getUint32(16, true), step: view.getUint32(20, true),
    samples: new Float32Array(bytes.buffer, bytes.byteOffset + header, samples * 8),
    bounces: new DataView(bytes.buffer, bytes.byteOffset + end, bytes.byteLength - end),
  };
}

/** Bytes of a stream, a wanted number at a time. */
class Reader {
  private readonly reader: ReadableStreamDefaultReader<Uint8Array>;
  private rest = new Uint8Array(0);

  constructor(stream: ReadableStream<Uint8Array>) {
    this.reader = stream.getReader();
  }

  /** Writes into all of `to`; false at the end of the stream. */
  async fill(to: Uint8Array): Promise<boolean> {
    let done = 0;
    while (done < to.length) {
      if (this.rest.length === 0) {
        const { value } = await this.reader.read();
        if (!value) {
          if (done > 0) throw new Error("the deep buffer was cut off");
          return false;
        }
        this.rest = value as Uint8Array<ArrayBuffer>;
      }
      const count = Math.min(this.rest.length, to.length - done);
      to.set(this.rest.subarray(0, count), done);
      this.rest = this.rest.subarray(count);
      done += count;
    }
    return true;
  }
}

/** Calls `use` for each message of an answer, as soon as it is whole. */
export async function readPasses(reply: Response, use: (pass: Pass) => void): Promise<void> {
  const reader = new Reader(reply.body!);
  for (;;) {
    const head = new Uint8Array(header);
    if (!await reader.fill(head)) return;
    if (new TextDecoder().decode(head.subarray(0, 8)) !== magic) throw new Error("this is no deep buffer");
    const bytes = new Uint8Array(sizeOf(new DataView(head.buffer)));
    bytes.set(head);
    await reader.fill(bytes.subarray(header));
    use(passOf(bytes));
  }
}
