#!/usr/bin/env python3
"""Makes text_detection.onnx of PP-OCRv4's ch_PP-OCRv4_det_infer.onnx, for OpenCV 4.6.

    convert_text_detection.py CH_PP-OCRV4_DET_INFER.ONNX TEXT_DETECTION.ONNX

OpenCV 4.6 does not read Clip with its limits as inputs. The network has them in its hard swishes only,
x * clip(x + 3, 0, 6) / 6. Each becomes x * HardSigmoid(x), which is the same. No weight is changed. Needs python3-onnx.
"""
import sys

import onnx
from onnx import helper, numpy_helper


def constants(graph):
    """The values of the graph's constants by name."""
    return {node.output[0]: numpy_helper.to_array(node.attribute[0].t) for node in graph.node if node.op_type == "Constant"}


def is_value(known, name, value):
    return name in known and known[name].size == 1 and float(known[name].reshape(-1)[0]) == value


def only_user(graph, name, kind):
    users = [node for node in graph.node if name in node.input]
    assert len(users) == 1 and users[0].op_type == kind, f"{name} is not used by one {kind}"
    return users[0]


def replace_swish(graph, known, clip):
    """Add, Clip, Mul and Div become HardSigmoid and Mul."""
    add = next(node for node in graph.node if clip.input[0] in node.output)
    assert add.op_type == "Add" and is_value(known, clip.input[1], 0) and is_value(known, clip.input[2], 6)
    x = next(name for name in add.input if name not in known)
    assert any(is_value(known, name, 3) for name in add.input)
    product = only_user(graph, clip.output[0], "Mul")
    assert x in product.input
    quotient = only_user(graph, product.output[0], "Div")
    assert is_value(known, quotient.input[1], 6)
    gate = helper.make_node("HardSigmoid", [x], [clip.output[0]], alpha=1 / 6, beta=0.5)
    swish = helper.make_node("Mul", [x, clip.output[0]], [quotient.output[0]])
    place = list(graph.node).index(quotient)
    graph.node.insert(place, swish)
    graph.node.insert(place, gate)
    for node in (add, clip, product, quotient):
        graph.node.remove(node)


def remove_unused(graph):
    used = {name for node in graph.node for name in node.input}
    for node in [node for node in graph.node if node.op_type == "Constant" and node.output[0] not in used]:
        graph.node.remove(node)


def main():
    source, target = sys.argv[1:]
    model = onnx.load(source)
    known = constants(model.graph)
    for clip in [node for node in model.graph.node if node.op_type == "Clip"]:
        replace_swish(model.graph, known, clip)
    remove_unused(model.graph)
    onnx.checker.check_model(model)
    onnx.save(model, target)


if __name__ == "__main__":
    main()
