// The only place that talks to the server: one error shape in, one error class out.

import { language, t } from "./words";

/** Where in a file, a session or a form something went wrong; its keys depend on the error's code. */
export type Where = Record<string, unknown>;

/** A refusal by the server, or (status 0) no answer from it at all. */
export class ApiError extends Error {
  constructor(
    readonly code: string,
    message: string,
    readonly where: Where | null,
    readonly mend: string | null,
    readonly status: number,
    /** A way on that the server offers, such as `fill_gaps`. */
    readonly offer: string | null = null,
    /** Everything else that the server said about it. */
    readonly detail: Where = {},
  ) {
    super(message);
    this.name = "ApiError";
  }

  /** True when asking again later can help: no network, a busy or a failing server. */
  get transient(): boolean {
    return this.status === 0 || this.status === 429 || this.status >= 500;
  }
}

export interface RequestOptions {
  /** Query parameters; an empty or missing value is left out. */
  query?: Record<string, string | number | boolean | null | undefined>;
  signal?: AbortSignal;
  /** Let the request outlive the page (the last answer before a tab closes). */
  keepalive?: boolean;
}

type Method = "GET" | "POST" | "PATCH" | "PUT" | "DELETE";

const offline = () =>
  new ApiError("offline", t("The server did not answer. Check the connection, then try again."), null, null, 0);

export const api = {
  get: <T>(path: string, options?: RequestOptions) => send<T>("GET", path, undefined, options),
  post: <T>(path: string, body?: unknown, options?: RequestOptions) =>
    send<T>("POST", path, body, options),
  patch: <T>(path: string, body?: unknown, options?: RequestOptions) =>
    send<T>("PATCH", path, body, options),
  put: <T>(path: string, body?: unknown, options?: RequestOptions) =>
    send<T>("PUT", path, body, options),
  delete: <T = void>(path: string, options?: RequestOptions) =>
    send<T>("DELETE", path, undefined, options),
  upload,
  bytes,
  bytesFor,
  reply,
  page,
};

async function send<T>(
  method: Method,
  path: string,
  body: unknown,
  options: RequestOptions = {},
): Promise<T> {
  const response = await reach(withQuery(path, options.query), {
    method,
    headers: headers(method, body === undefined ? {} : { "Content-Type": "application/json" }),
    ...(body === undefined ? {} : { body: JSON.stringify(body) }),
    ...(options.signal ? { signal: options.signal } : {}),
    ...(options.keepalive ? { keepalive: true } : {}),
  });
  const text = await response.text();
  if (!response.ok) throw errorFrom(response.status, text);
  return (text ? JSON.parse(text) : undefined) as T;
}

/** Fetch an asset's bytes, such as a clip's GLB; `onShare` hears how much of it is there, from 0 to 1. */
async function bytes(
  path: string,
  signal?: AbortSignal,
  onShare?: (share: number) => void,
): Promise<ArrayBuffer> {
  const response = await reach(path, signal ? { signal } : {});
  if (!response.ok) throw errorFrom(response.status, await response.text());
  return onShare && response.body ? metered(response, onShare) : response.arrayBuffer();
}

/** Send a question whose answer is bytes, such as a recipe whose motion is wanted. */
async function bytesFor(path: string, body: unknown): Promise<ArrayBuffer> {
  return (await reply(path, body)).bytes;
}

/** The same, where the answer's headers say something too. */
async function reply(path: string, body: unknown): Promise<{ bytes: ArrayBuffer; headers: Headers }> {
  const response = await reach(path, {
    method: "POST",
    headers: headers("POST", { "Content-Type": "application/json", Accept: "*/*" }),
    body: JSON.stringify(body),
  });
  if (!response.ok) throw errorFrom(response.status, await response.text());
  return { bytes: await response.arrayBuffer(), headers: response.headers };
}

async function metered(response: Response, onShare: (share: number) => void): Promise<ArrayBuffer> {
  const total = Number(response.headers.get("Content-Length"));
  let loaded = 0;
  const meter = new TransformStream<Uint8Array, Uint8Array>({
    transform(chunk, controller) {
      loaded += chunk.byteLength;
      // The length counts compressed bytes, the chunks count plain ones.
      if (total) onShare(Math.min(1, loaded / total));
      controller.enqueue(chunk);
    },
  });
  return new Response(response.body?.pipeThrough(meter)).arrayBuffer();
}

/** Fetch a piece of a page, parsed but not yet in the document; its scripts do not run. */
async function page(path: string): Promise<DocumentFragment> {
  const response = await reach(path, { headers: { Accept: "text/html" } });
  const text = await response.text();
  if (!response.ok || response.redirected) throw errorFrom(response.status, "");
  const fragment = document.createDocumentFragment();
  fragment.append(...new DOMParser().parseFromString(text, "text/html").body.childNodes);
  return fragment;
}

async function reach(path: string, init: RequestInit): Promise<Response> {
  try {
    return await fetch(path, { credentials: "same-origin", ...init });
  } catch (cause) {
    if (cause instanceof DOMException && cause.name === "AbortError") throw cause;
    throw offline();
  }
}

/** Send files. XMLHttpRequest, because fetch cannot tell how much has gone out yet. */
function upload<T>(
  path: string,
  form: FormData,
  onProgress: (share: number) => void = () => {},
): Promise<T> {
  return new Promise((resolve, reject) => {
    const request = new XMLHttpRequest();
    request.open("POST", path);
    for (const [name, value] of Object.entries(headers("POST"))) {
      request.setRequestHeader(name, value);
    }
    request.upload.onprogress = ({ loaded, total }) => onProgress(total ? loaded / total : 0);
    request.onerror = () => reject(offline());
    request.onload = () => {
      if (request.status < 200 || request.status > 299) {
        reject(errorFrom(request.status, request.responseText));
      } else resolve(JSON.parse(request.responseText) as T);
    };
    request.send(form);
  });
}

/** The error that a refused response carries; a response in a foreign shape becomes one as well. */
export function errorFrom(status: number, text: string): ApiError {
  try {
    const { error } = JSON.parse(text);
    const { code, message, where, mend, offer, ...detail } = error;
    if (typeof message !== "string") throw new TypeError("no message");
    return new ApiError(String(code), message, where ?? null, mend ?? null, status, offer ?? null, detail);
  } catch {
    const message = t("The server answered with status {status} and no explanation.", { status });
    return new ApiError("unexplained", message, null, t("Try again in a moment."), status);
  }
}

function headers(method: Method, extra: Record<string, string> = {}): Record<string, string> {
  const csrf = document.querySelector<HTMLMetaElement>('meta[name="csrf-token"]')?.content;
  return {
    Accept: "application/json",
    "Accept-Language": language(),
    ...extra,
    ...(csrf && method !== "GET" ? { "X-CSRF-Token": csrf } : {}),
  };
}

function withQuery(path: string, query: RequestOptions["query"]): string {
  const parts = new URLSearchParams();
  for (const [name, value] of Object.entries(query ?? {})) {
    if (value !== undefined && value !== null && value !== "") parts.set(name, String(value));
  }
  const text = parts.toString();
  return text ? `${path}?${text}` : path;
}
