"""Compiles attributes, calls and macros in templates to those of Python.

Jinja calls functions of its own for each of them, which take longer than the rest of rendering: they
also look for keys of dictionaries, pass Jinja's context, and mark text as HTML. So in our templates a
key is written `x["key"]`, a function that needs the context is a filter, and only macros that return
HTML or have default arguments are those of Jinja.
"""

from __future__ import annotations

from jinja2 import nodes
from jinja2.compiler import CodeGenerator, Frame, MacroRef


class NativeCode(CodeGenerator):
    """The code generator of all environments."""

    def visit_Getattr(self, node: nodes.Getattr, frame: Frame) -> None:
        self.write("(")
        self.visit(node.node, frame)
        self.write(f").{node.attr}")

    def visit_Call(self, node: nodes.Call, frame: Frame, forward_caller: bool = False) -> None:
        self.visit(node.node, frame)
        assert not node.dyn_args and not node.dyn_kwargs
        self.write("(")
        for argument in (*node.args, *node.kwargs):
            self.visit(argument, frame)
            self.write(", ")
        self.write("caller=caller)" if forward_caller else ")")

    def macro_def(self, macro_ref: MacroRef, frame: Frame) -> None:
        special = macro_ref.accesses_caller, macro_ref.accesses_kwargs, macro_ref.accesses_varargs
        if frame.eval_ctx.autoescape or any(special) or macro_ref.node.defaults:
            super().macro_def(macro_ref, frame)
        else:
            self.write("macro")
