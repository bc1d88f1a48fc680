// Keeps the playground of one version of the site for use without a network. The build defines its
// files and their fingerprint, so that a change of any file makes another service worker.

export {};

declare const FILES: string[];
declare const FINGERPRINT: string;

const worker = globalThis as unknown as ServiceWorkerGlobalScope;
const prefix = `sbgc ${worker.registration.scope} `;
const cacheName = prefix + FINGERPRINT;
const kept = new Set(FILES.map((file) => new URL(file, worker.registration.scope).href));

worker.addEventListener("install", (event) => {
  const fetched = FILES.map((file) => new Request(file, { cache: "no-cache" }));
  event.waitUntil(caches.open(cacheName).then((cache) => cache.addAll(fetched)));
});

worker.addEventListener("activate", (event) => {
  const clean = async (): Promise<void> => {
    const old = (await caches.keys()).filter((one) => one.startsWith(prefix) && one !== cacheName);
    await Promise.all(old.map((one) => caches.delete(one)));
  };
  event.waitUntil(clean());
});

worker.addEventListener("message", (event) => {
  if (event.data === "take over") void worker.skipWaiting();
});

/** Only the files of the playground: the rest of the site stays with the browser. */
worker.addEventListener("fetch", (event) => {
  const { origin, pathname } = new URL(event.request.url);
  const file = origin + pathname;
  if (event.request.method !== "GET" || !kept.has(file)) return;
  const answer = async (): Promise<Response> =>
    (await (await caches.open(cacheName)).match(file)) ?? fetch(event.request);
  event.respondWith(answer());
});
