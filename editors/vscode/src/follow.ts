// Following a text: one question at a time, and the newest text next.

/** Calls `ask` again and again while there is something new, never twice at once. */
export class Follower {
  private asking = false;
  private again = false;
  private ended = false;

  constructor(
    private readonly ask: () => Promise<void>,
    private readonly failed: (error: unknown) => void,
  ) {}

  /** There is something new. */
  poke(): void {
    this.again = true;
    if (!this.asking) void this.run();
  }

  end(): void {
    this.ended = true;
  }

  private async run(): Promise<void> {
    this.asking = true;
    while (this.again && !this.ended) {
      this.again = false;
      try {
        await this.ask();
      } catch (error) {
        this.failed(error);
      }
    }
    this.asking = false;
  }
}
