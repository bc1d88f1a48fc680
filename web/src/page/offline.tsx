// Registers the service worker, which keeps the playground for use without a network.

import { useEffect, useState } from "preact/hooks";

import { SmallButton } from "./inputs.js";

export function Offline() {
  const [newer, setNewer] = useState<ServiceWorker | null>(null);
  useEffect(() => {
    const workers = navigator.serviceWorker; // absent without https
    if (!workers || !location.protocol.startsWith("http")) return;
    const watch = (registration: ServiceWorkerRegistration): void => {
      const next = registration.waiting ?? registration.installing;
      if (!next || !workers.controller) return;
      const tell = (): void => {
        if (next.state === "installed") setNewer(next);
      };
      next.addEventListener("statechange", tell);
      tell();
    };
    workers.register("service-worker.js").then(
      (registration) => {
        watch(registration);
        registration.addEventListener("updatefound", () => watch(registration));
      },
      () => undefined, // the page works without it
    );
  }, []);
  if (!newer) return null;
  const take = (): void => {
    navigator.serviceWorker.addEventListener("controllerchange", () => location.reload());
    newer.postMessage("take over");
  };
  return (
    <div class="note" role="status">
      <p>
        A newer version of this page is there.{" "}
        <SmallButton onClick={take}>Use it</SmallButton>
      </p>
    </div>
  );
}
