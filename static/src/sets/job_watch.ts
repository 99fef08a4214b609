// Follows a job on the server while its page is open. The server works on whether anybody looks or not.

import type { ReactiveController, ReactiveControllerHost } from "lit";
import { api, ApiError } from "../api";
import { isOpen, marked, settled, type Job, type Mark } from "./model";

const EVERY = 500; // milliseconds
const AFTER_FAULT = 3000;

export class JobWatch implements ReactiveController {
  job: Job | undefined;
  /** Why nothing new is known; the job itself may well go on. */
  problem: ApiError | undefined;
  marks: Mark[] = [];
  private timer = 0;

  constructor(
    private readonly host: ReactiveControllerHost,
    private readonly onEnd: (job: Job) => void,
  ) {
    host.addController(this);
  }

  hostConnected(): void {
    if (this.job) this.follow(this.job);
  }

  hostDisconnected(): void {
    clearTimeout(this.timer);
  }

  /** Show a job, and ask for it again and again until it has ended. */
  follow(job: Job): void {
    if (job.id !== this.job?.id) this.marks = [];
    const ended = this.job !== undefined && isOpen(this.job) && !isOpen(job);
    this.job = job;
    this.problem = undefined;
    this.marks = marked(this.marks, { time: performance.now() / 1000, settled: settled(job) });
    clearTimeout(this.timer);
    if (isOpen(job)) this.timer = window.setTimeout(() => void this.ask(job.id), EVERY);
    else if (ended) this.onEnd(job);
    this.host.requestUpdate();
  }

  forget(): void {
    clearTimeout(this.timer);
    this.job = this.problem = undefined;
    this.host.requestUpdate();
  }

  async ask(id: string): Promise<void> {
    try {
      const job = await api.get<Job>(`/api/v1/jobs/${id}`);
      if (!this.job || this.job.id === id) this.follow(job);
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      this.problem = error;
      if (error.transient) this.timer = window.setTimeout(() => void this.ask(id), AFTER_FAULT);
      this.host.requestUpdate();
    }
  }

  async stop(): Promise<void> {
    if (!this.job) return;
    try {
      this.follow(await api.delete<Job>(`/api/v1/jobs/${this.job.id}`));
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      this.problem = error;
      this.host.requestUpdate();
    }
  }
}
