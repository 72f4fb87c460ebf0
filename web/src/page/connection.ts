// The live connection: asks one design after the other, the newest first, and hands on answers to the newest alone.

import { decodeMesh, type ModelFrame, Topologies, TopologyMissing } from "../scene/frame";
import type { About, Answer, Ask, Design } from "./protocol";

export type Wish = { design: Design; density: number | null; material: string | null; about: About };
export type Link = "connecting" | "open" | "lost";

export interface Listener {
  mesh(frame: ModelFrame, of: Wish): void;
  answer(answer: Answer, of: Wish | null): void; // of: what was asked last
  link(state: Link): void;
  busy(waiting: boolean): void;
}

// While an answer is under way the next ask waits: for so long, and after its mesh for its values (milliseconds). Where
// these take longer the waits grow with them, else a slider in hand would overtake every one of them.
const PATIENCE = { least: 1000, most: 10_000 };
const REST = { least: 250, most: 3000 };
const RETRY = { least: 500, most: 10_000 };
const LAST = ["values", "refused", "failed", "done"]; // with one of these the next ask may go

export class Connection {
  private socket: WebSocket | null = null;
  private readonly known = new Topologies();
  private wish: Wish | null = null; // still to be asked
  private asked: Wish | null = null; // the last that was
  private id = 0;
  private underWay = false;
  private planned = 0; // the frame in which the next ask goes
  private timer = 0;
  private retry = RETRY.least;
  private patience = PATIENCE.least;
  private rest = REST.least;
  private sent = 0; // when the last ask went
  private drew = 0; // when its mesh came
  private closed = false;
  private whole = false; // whether the next answer is to hold all topologies

  constructor(private readonly listener: Listener, private readonly address: () => string = live) {
    this.connect();
  }

  // Of wishes that come faster than they can be asked only the newest is.
  ask(wish: Wish): void {
    this.wish = wish;
    this.listener.busy(true);
    if (!this.underWay) this.plan();
  }

  close(): void {
    this.closed = true;
    clearTimeout(this.timer);
    this.socket?.close();
  }

  private plan(): void {
    if (this.planned) return;
    const go = () => {
      this.planned = 0;
      this.send();
    };
    this.planned = document.hidden ? window.setTimeout(go, 50) : requestAnimationFrame(go);
  }

  private send(): void {
    if (!this.wish || this.socket?.readyState !== WebSocket.OPEN) return;
    const wish = this.wish;
    this.asked = wish;
    this.wish = null;
    this.underWay = true;
    this.id += 1;
    const { design, density, material } = wish;
    const have = this.whole ? [] : this.known.held();
    const ask: Ask = { ask: "design", id: this.id, design, density, material, have };
    this.whole = false;
    this.socket.send(JSON.stringify(ask));
    this.sent = performance.now();
    this.after(this.patience, () => {
      this.patience = within(2 * this.patience, PATIENCE);
    });
  }

  // Lets the next ask go after so long, whatever has been answered until then.
  private after(wait: number, late: () => void = () => {}): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => {
      late();
      this.next();
    }, wait);
  }

  private next(): void {
    clearTimeout(this.timer);
    this.underWay = false;
    if (this.wish) this.plan();
  }

  private connect(): void {
    this.listener.link("connecting");
    const socket = new WebSocket(this.address());
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    socket.addEventListener("open", () => {
      this.retry = RETRY.least;
      this.listener.link("open");
      this.plan();
    });
    socket.addEventListener("message", (event: MessageEvent<string | ArrayBuffer>) => this.took(event.data));
    socket.addEventListener("close", () => this.lost());
  }

  // What was asked last is asked again, once there is a connection again.
  private lost(): void {
    if (this.closed) return;
    this.next();
    this.wish ??= this.asked;
    this.listener.link("lost");
    window.setTimeout(() => {
      if (!this.closed) this.connect();
    }, this.retry);
    this.retry = Math.min(2 * this.retry, RETRY.most);
  }

  // A topology that is not kept any more is asked for again.
  private drawn(data: ArrayBuffer): void {
    this.drew = performance.now();
    this.patience = within(2 * (this.drew - this.sent), PATIENCE);
    try {
      this.listener.mesh(decodeMesh(data, this.known), this.asked!);
      this.after(this.rest, () => {
        this.rest = within(2 * this.rest, REST);
      });
    } catch (error) {
      if (!(error instanceof TopologyMissing)) throw error;
      this.wish ??= this.asked;
      this.whole = true;
      this.next();
    }
  }

  private took(data: string | ArrayBuffer): void {
    if (data instanceof ArrayBuffer) {
      if (idOf(data) !== this.id) return;
      this.drawn(data);
      return;
    }
    const answer = JSON.parse(data) as Answer;
    if ("id" in answer && answer.id !== this.id) return;
    if (answer.answer === "values") this.rest = within(2 * (performance.now() - this.drew), REST);
    this.listener.answer(answer, this.asked);
    if (["done", "refused", "failed"].includes(answer.answer)) this.listener.busy(this.wish !== null);
    if (LAST.includes(answer.answer)) this.next();
  }
}

const within = (value: number, { least, most }: { least: number; most: number }) => Math.min(Math.max(value, least), most);

// Whose answer a mesh frame is, read without decoding the rest.
function idOf(data: ArrayBuffer): number {
  const length = new DataView(data).getUint32(0, true);
  return (JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, length))) as { id: number }).id;
}

function live(): string {
  const address = new URL("api/live", location.href);
  address.protocol = address.protocol.replace("http", "ws");
  address.hash = address.search = "";
  return address.href;
}
