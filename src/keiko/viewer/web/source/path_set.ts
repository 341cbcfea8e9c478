/** A set of paths, which is listed and emptied at the cost of what is in it. */
export class PathSet {
  count = 0;
  list = new Uint32Array(1);
  private members = new Uint8Array(1);

  /** Makes room for so many paths. */
  reserve(paths: number): void {
    if (this.list.length >= paths) return;
    const list = new Uint32Array(2 * paths), members = new Uint8Array(2 * paths);
    list.set(this.list), members.set(this.members);
    this.list = list, this.members = members;
  }

  add(path: number): void {
    if (this.members[path] === 1) return;
    this.members[path] = 1;
    this.list[this.count++] = path;
  }

  clear(): void {
    for (let i = 0; i < this.count; ++i) this.members[this.list[i]] = 0;
    this.count = 0;
  }
}
