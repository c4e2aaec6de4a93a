// Following a text: one question at a time, and the newest text next.

import { overtaken } from "./protocol";

/** Milliseconds before a question that was overtaken is asked again. */
const PAUSE = 50;

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

  /** What overtook the question may concern another text than ours, of which nobody will tell. */
  private async pause(): Promise<void> {
    this.again = true;
    await new Promise(resolve => setTimeout(resolve, PAUSE));
  }

  private async run(): Promise<void> {
    this.asking = true;
    while (this.again && !this.ended) {
      this.again = false;
      try {
        await this.ask();
      } catch (error) {
        if (overtaken(error)) await this.pause();
        else this.failed(error);
      }
    }
    this.asking = false;
  }
}
