// What goes to and fro between the page and the program.
let token = takeToken();

// From the address that the program printed; it stays until the tab is closed, and out of sight.
function takeToken() {
  const given = new URLSearchParams(location.hash.slice(1)).get("token");
  if (given) {
    sessionStorage.setItem("token", given);
    history.replaceState(null, "", location.pathname);
  }
  return given ?? sessionStorage.getItem("token");
}

export const mayChange = () => Boolean(token);

export async function fetchState() {
  return (await fetch("state")).json();
}

export async function fetchLine(number) {
  return (await fetch(number === undefined ? "line" : "line?number=" + number)).json();
}

// The answer's bytes; null where there is nothing newer.
export async function fetchView(after) {
  const answer = await fetch(after === undefined ? "view" : "view?after=" + after);
  return answer.status === 200 ? answer.arrayBuffer() : null;
}

// What the program says; an error with its reason where it refuses.
export async function ask(action, body = {}) {
  const answer = await fetch("act/" + action, {
    method: "POST",
    headers: {"Content-Type": "application/json", "Aspect-Token": token ?? ""},
    body: JSON.stringify(body)});
  if (!answer.ok) throw new Error((await answer.text()).trim() || "refused");
  const said = await answer.json();
  if (said.refused) throw new Error(said.refused);
  return said;
}

// Sends what was given last, one after the other: a slider moves faster than a network.
export class Latest {
  #send; #next; #busy = false;
  constructor(send) { this.#send = send; }
  async give(value) {
    this.#next = [value];
    if (this.#busy) return;
    this.#busy = true;
    try {
      while (this.#next) {
        const [now] = this.#next;
        this.#next = undefined;
        await this.#send(now);
      }
    } finally {
      this.#busy = false;
    }
  }
  get busy() { return this.#busy; }
}
