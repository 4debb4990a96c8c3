// node validate.cjs FOLDER_OF_AJV SCHEMA PROTOCOLS
// PROTOCOLS is a JSON array. Prints for each protocol one line: "valid", or "invalid" and why.
"use strict";
const fs = require("fs");
const { createRequire } = require("module");

const [folder, schemaFile, protocolsFile] = process.argv.slice(2);
const Ajv = createRequire(folder + "/")("ajv/dist/2020").default;
const read = (file) => JSON.parse(fs.readFileSync(file, "utf8"));

// Strict: an unknown or misplaced keyword in the schema is an error.
const ajv = new Ajv({ strict: true, strictTypes: false, strictRequired: false });
const validate = ajv.compile(read(schemaFile));
for (const protocol of read(protocolsFile)) {
  console.log(validate(protocol) ? "valid" : "invalid " + ajv.errorsText(validate.errors));
}
