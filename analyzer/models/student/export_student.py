"""Writes the student as an ONNX file that OpenCV 4.6 reads."""

import onnx
import torch

from student import SIDE, Answer


def write_onnx(student, file):
    """The file holds the network with its normalisations folded into the convolutions (operators of 11)."""
    answer = Answer(student).cpu().float().eval()
    picture = torch.zeros(1, 3, SIDE, SIDE)
    options = {"dynamo": False} if int(torch.__version__.split(".")[0]) >= 2 else {}
    torch.onnx.export(
        answer, picture, file, opset_version=11, input_names=["picture"], output_names=["map"], **options
    )
    shorten_names(file)


def shorten_names(file):
    """Names of tensors and operators are a tenth of the file, and nobody asks for them."""
    model = onnx.load(file)
    names = {"picture": "picture", "map": "map", "": ""}
    for node in model.graph.node:
        node.ClearField("name")
        node.ClearField("doc_string")
        for ends in (node.input, node.output):
            ends[:] = [names.setdefault(name, str(len(names))) for name in ends]
    for weight in model.graph.initializer:
        weight.name = names[weight.name]
    onnx.checker.check_model(model)
    onnx.save(model, file)
