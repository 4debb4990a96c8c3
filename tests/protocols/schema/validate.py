"""validate.py SCHEMA PROTOCOLS: PROTOCOLS is a JSON array; prints for each protocol one line, "valid",
or "invalid" and why."""

import json
import sys

from jsonschema import Draft202012Validator

with open(sys.argv[1], encoding="utf-8") as file:
    schema = json.load(file)
with open(sys.argv[2], encoding="utf-8") as file:
    protocols = json.load(file)

Draft202012Validator.check_schema(schema)
validator = Draft202012Validator(schema)
for protocol in protocols:
    error = next(validator.iter_errors(protocol), None)
    print("valid" if error is None else "invalid " + error.message.replace("\n", " "))
