"""Generator for the SimpleBGC protocol: YAML in, code, documentation and test data out.

Packages, each of which imports only those above it:

- `model/`: the resolved protocol as frozen dataclasses, its names, and its export as JSON;
- `spec/`: reads the YAML into the model and reports each mistake at its line;
- `oracle/`: an independent codec, and the values for examples and tests;
- `views/`: facts derived from the model that several targets show;
- `targets/`: one folder for each kind of output;
- `compat/`: the changes between two versions of the protocol.

`build.py` loads and checks a spec, `output.py` writes the output of the targets, `record.py` detects a
run with nothing to do, `library.py` finds the version and the headers of the C++ library,
`blocking.py` makes the blocking client of the Python package, `cli.py` is the command line.
"""
