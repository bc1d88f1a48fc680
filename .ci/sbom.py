"""Writes what the files of a release consist of, in the format SPDX 2.3: sbom.py VERSION COMMIT FOLDER."""

from __future__ import annotations

import hashlib
import json
import os
import re
import subprocess
import sys
from datetime import datetime, timezone
from pathlib import Path
from typing import Any

# The libraries that are part of a file, as packages of Debian, or of npm in web, and their licenses.
LICENSES = {
    "libasio-dev": "BSL-1.0",
    "libc++-dev-wasm32": "Apache-2.0 WITH LLVM-exception",
    "libcli11-dev": "BSD-3-Clause",
    "libfmt-dev": "MIT",
    "libkissfft-dev": "BSD-3-Clause",
    "minisearch": "MIT",
    "nlohmann-json3-dev": "MIT",
    "preact": "MIT",
    "pybind11-dev": "BSD-3-Clause",
    "three": "MIT",
    "uplot": "MIT",
    "wasi-libc": "MIT",
}
LIBRARY = ("libasio-dev", "libfmt-dev", "libkissfft-dev", "nlohmann-json3-dev")
WEB = ("libc++-dev-wasm32", "libfmt-dev", "libkissfft-dev", "nlohmann-json3-dev", "wasi-libc")
PARTS = {
    r"sbgc_.*\.deb": (*LIBRARY, "libcli11-dev"),
    r"libsbgc-dev_.*\.deb": LIBRARY,
    r"python3-sbgc_.*\.deb": (*LIBRARY, "pybind11-dev"),
    r"sbgc-.*\.whl": (*LIBRARY, "pybind11-dev"),
    r"sbgc-site-.*\.zip": (*WEB, "minisearch", "preact", "three", "uplot"),
    r"sbgc-npm-.*\.tgz": WEB,
    r"sbgc-arduino-.*\.zip": (),
    r"sbgc-fuzz-seeds-.*\.zip": (),
    r"sbgc-.*\.tar\.gz": (),
    r"sbgc\.hpp": (),
}


def parts_of(name: str) -> tuple[str, ...]:
    """The libraries in a file."""
    found = next((parts for pattern, parts in PARTS.items() if re.fullmatch(pattern, name)), None)
    if found is None:
        sys.exit(f"sbom.py: it is unknown what {name} consists of")
    return found


def version_of(package: str) -> str:
    """The version of an installed package, or of one of npm; "" for none."""
    of_npm = json.loads((Path(__file__).parent.parent / "web/package.json").read_text("utf-8"))
    if package in of_npm["devDependencies"]:
        return str(of_npm["devDependencies"][package])
    command = ["dpkg-query", "-W", "-f", "${Version}", package]
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout


def id_of(name: str) -> str:
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", name)


def package(name: str, version: str, license: str) -> dict[str, Any]:
    return {
        "SPDXID": id_of(f"package-{name}"),
        "name": name,
        **({"versionInfo": version} if version else {}),
        "downloadLocation": "NOASSERTION",
        "filesAnalyzed": False,
        "licenseConcluded": license,
        "licenseDeclared": license,
        "copyrightText": "NOASSERTION",
    }


def file(path: Path, license: str) -> dict[str, Any]:
    data = path.read_bytes()
    sums = {"SHA1": hashlib.sha1(data), "SHA256": hashlib.sha256(data)}
    return {
        "SPDXID": id_of(f"file-{path.name}"),
        "fileName": f"./{path.name}",
        "checksums": [
            {"algorithm": name, "checksumValue": sum_.hexdigest()} for name, sum_ in sums.items()
        ],
        "licenseConcluded": license,
        "copyrightText": "NOASSERTION",
    }


def relation(one: str, kind: str, other: str) -> dict[str, str]:
    return {"spdxElementId": one, "relationshipType": kind, "relatedSpdxElement": other}


def document(version: str, commit: str, folder: Path) -> dict[str, Any]:
    """The description of the files in a folder."""
    paths = sorted(path for path in folder.iterdir() if path.is_file())
    parts = {path.name: parts_of(path.name) for path in paths}
    names = sorted({part for found in parts.values() for part in found})
    time = datetime.fromtimestamp(int(os.environ["SOURCE_DATE_EPOCH"]), timezone.utc)
    whole = "SPDXRef-DOCUMENT"
    relations = [relation(whole, "DESCRIBES", id_of("package-sbgc"))]
    files = []
    for path in paths:
        licenses = sorted({"MIT", *(LICENSES[part] for part in parts[path.name])})
        files.append(file(path, " AND ".join(licenses)))
        relations.append(relation(id_of("package-sbgc"), "CONTAINS", files[-1]["SPDXID"]))
        for part in parts[path.name]:
            other = id_of(f"package-{part}")
            relations.append(relation(files[-1]["SPDXID"], "STATIC_LINK", other))
    return {
        "spdxVersion": "SPDX-2.3",
        "dataLicense": "CC0-1.0",
        "SPDXID": whole,
        "name": f"sbgc-{version}",
        "documentNamespace": f"https://example.com/spdx/sbgc-{version}-{commit}",
        "creationInfo": {
            "created": time.strftime("%Y-%m-%dT%H:%M:%SZ"),
            "creators": ["Organization: The sbgc authors", "Tool: .ci/sbom.py"],
        },
        "packages": [
            package("sbgc", version, "MIT"),
            *(package(name, version_of(name), LICENSES[name]) for name in names),
        ],
        "files": files,
        "relationships": relations,
    }


def main() -> None:
    version, commit, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    text = json.dumps(document(version, commit, folder), indent=2)
    (folder / f"sbgc-{version}.spdx.json").write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
