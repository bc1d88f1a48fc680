"""Generator for the SimpleBGC protocol: YAML in, code, documentation and test data out.

The rooms, each of which uses only those above it:

- `model/`: what the protocol is, frozen; its export as JSON, its names;
- `spec/`: from YAML to the model, with every mistake at its line;
- `oracle/`: a second codec, and the values that show and test the first one;
- `views/`: what several targets show beyond the model;
- `targets/`: a folder for each thing that is made of it;
- `compat/`: what changed between two versions of it.

`build.py` puts the rooms together, `output.py` writes what the targets make, `cli.py` is the command.
"""
