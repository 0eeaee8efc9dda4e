// SPDX-License-Identifier: MIT
// `flipbook serve` as a child: started on any free port with an output folder of its own, stopped as Ctrl-C would.
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout as sleep } from "node:timers/promises";

export const flipbook = process.env.FLIPBOOK ?? new URL("../../build/release/flipbook", import.meta.url).pathname;

export class Program {
  #process;
  #said = "";
  folder;
  url; // with the token
  ended; // the exit code, once there is one

  /// `what`: arguments after `serve`. `token` keeps the link the same from one start to the next.
  static async start(what = ["dam_break"], { port = 0, token, folder = mkdtempSync(join(tmpdir(), "flipbook-serve-")) } = {}) {
    const program = new Program();
    program.folder = folder;
    const environment = token ? { ...process.env, FLIPBOOK_TOKEN: token } : process.env;
    program.#process = spawn(flipbook, ["serve", ...what, "--port", String(port), "-o", folder], {
      env: environment,
      stdio: ["ignore", "pipe", "pipe"],
    });
    for (const stream of [program.#process.stdout, program.#process.stderr]) stream.on("data", (data) => (program.#said += data));
    program.ended = new Promise((resolve) => program.#process.on("exit", resolve));
    process.on("exit", () => program.#process.kill("SIGKILL")); // whatever ends the test
    const printed = new Promise((resolve) => program.#process.stdout.on("data", () => program.#address() && resolve()));
    await Promise.race([printed, program.ended, sleep(30000, undefined, { ref: false })]);
    program.url = program.#address();
    if (!program.url) throw new Error(`flipbook serve printed no address: ${program.#said}`);
    return program;
  }

  #address() {
    return this.#said.match(/http:\/\/\S+token=[\w-]+/)?.[0];
  }

  get port() {
    return Number(new URL(this.url).port);
  }
  get pid() {
    return this.#process.pid;
  }
  /// Everything that it printed.
  get said() {
    return this.#said;
  }
  /// Resident memory in MiB.
  get memory() {
    return Number(readFileSync(`/proc/${this.pid}/status`, "utf8").match(/VmRSS:\s+(\d+)/)[1]) / 1024;
  }

  async stop({ keep = false } = {}) {
    this.#process.kill("SIGINT");
    const code = await Promise.race([this.ended, sleep(20000, "did not end", { ref: false })]);
    if (code === "did not end") this.#process.kill("SIGKILL");
    if (!keep) rmSync(this.folder, { recursive: true, force: true });
    return code;
  }
}
