// SPDX-License-Identifier: GPL-3.0-or-later
// node read_mcap.mjs FILE
// Reads an MCAP file of ROS 2 messages with other people's readers, from front to back and by its
// index, checks every CRC, decodes every message and prints a JSON object:
//   {profile, library, channels: [{topic, schema, encoding, messages, metadata}],
//    attachments: [{name, mediaType, size}], metadata: {name: {…}}, errors: [],
//    first: {topic: its first message in the file, decoded}}
// Byte arrays are {length, first: [at most 240 of them]}. Exit code: 0, 1 with errors, 2 usage.
import { readFileSync } from "node:fs";
import { isDeepStrictEqual } from "node:util";
import { crc32 } from "@foxglove/crc";
import { parse } from "@foxglove/rosmsg";
import { MessageReader, MessageWriter } from "@foxglove/rosmsg2-serialization";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { decompress } from "fzstd";

const decompressHandlers = {
  zstd: (bytes, size) => decompress(bytes, new Uint8Array(Number(size))),
};

/** Decodes messages of one schema, and sees that nothing of their bytes was left over. */
class Codec {
  constructor(schema) {
    if (schema.encoding !== "ros2msg") throw new Error(`a schema in ${schema.encoding}`);
    const definitions = parse(new TextDecoder().decode(schema.data), { ros2: true });
    this.reader = new MessageReader(definitions);
    this.writer = new MessageWriter(definitions);
  }

  decode(bytes) {
    const message = this.reader.readMessage(bytes);
    // The encoder counts a string's characters where its bytes are meant.
    const isAscii = /^[\x00-\x7f]*$/.test(JSON.stringify(message, plain));
    if (isAscii && Buffer.compare(this.writer.writeMessage(message), bytes) !== 0)
      throw new Error("encoded again, the message has other bytes");
    return message;
  }
}

/** What a reader sees that goes from front to back. */
class Contents {
  schemas = new Map();
  codecs = new Map();
  channels = new Map();
  messages = [];
  attachments = [];
  metadata = {};
  first = {};

  take(record) {
    switch (record.type) {
      case "Header":
        this.header = record;
        break;
      case "Schema":
        this.schemas.set(record.id, record);
        break;
      case "Channel":
        if (!this.channels.has(record.id)) this.channels.set(record.id, { record, messages: 0 });
        break;
      case "Chunk":
        if (record.uncompressedCrc === 0) throw new Error("a chunk has no CRC");
        break;
      case "Message":
        this.takeMessage(record);
        break;
      case "Attachment":
        this.attachments.push({ name: record.name, mediaType: record.mediaType, size: record.data.length });
        break;
      case "Metadata":
        this.metadata[record.name] = Object.fromEntries(record.metadata);
        break;
    }
  }

  takeMessage(message) {
    const channel = this.channels.get(message.channelId);
    const { topic, schemaId } = channel.record;
    ++channel.messages;
    this.messages.push(message);
    try {
      if (!this.codecs.has(schemaId)) this.codecs.set(schemaId, new Codec(this.schemas.get(schemaId)));
      const decoded = this.codecs.get(schemaId).decode(message.data);
      this.first[topic] ??= decoded;
    } catch (error) {
      throw new Error(`${topic}, message ${message.sequence}: ${error.message}`);
    }
  }
}

function readThrough(bytes) {
  const contents = new Contents();
  const reader = new McapStreamReader({ includeChunks: true, validateCrcs: true, decompressHandlers });
  reader.append(bytes);
  for (let record; (record = reader.nextRecord()); ) contents.take(record);
  if (!reader.done()) throw new Error(`the file ends early, ${reader.bytesRemaining()} bytes into a record`);
  return contents;
}

const byTime = (a, b) => Number(a.logTime - b.logTime) || a.channelId - b.channelId || a.sequence - b.sequence;

/** The index must lead to the same messages. */
async function readByIndex(bytes, contents) {
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, size) => bytes.subarray(Number(offset), Number(offset + size)),
  };
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  if (reader.footer.summaryCrc === 0) throw new Error("the summary has no CRC");
  const dataCrc = crc32(bytes.subarray(0, Number(reader.dataEndOffset)));
  if (reader.dataSectionCrc !== dataCrc)
    throw new Error(`incorrect CRC of the data ${dataCrc} (expected ${reader.dataSectionCrc})`);
  const messages = [];
  for await (const message of reader.readMessages({ validateCrcs: true })) messages.push(message);
  if (!isDeepStrictEqual(messages.sort(byTime), contents.messages.sort(byTime)))
    throw new Error(`the index leads to ${messages.length} messages, not to the same ${contents.messages.length}`);
  if (Number(reader.statistics.messageCount) !== messages.length)
    throw new Error(`${messages.length} messages, ${reader.statistics.messageCount} by the statistics`);
  for (const [id, { messages: count }] of contents.channels)
    if (Number(reader.statistics.channelMessageCounts.get(id) ?? 0) !== count)
      throw new Error(`the statistics are wrong on channel ${id}`);
}

/** MCAP specification, Registry, ROS2. */
function checkProfile(contents) {
  if (contents.header.profile !== "ros2") throw new Error(`profile is "${contents.header.profile}"; legal: ros2`);
  for (const { record } of contents.channels.values()) {
    if (record.messageEncoding !== "cdr") throw new Error(`${record.topic} is in ${record.messageEncoding}; legal: cdr`);
    if (!record.metadata.has("offered_qos_profiles")) throw new Error(`${record.topic} offers no quality of service`);
  }
}

function describe(contents) {
  return {
    profile: contents.header?.profile,
    library: contents.header?.library,
    channels: [...contents.channels.values()].map(({ record, messages }) => ({
      topic: record.topic,
      schema: contents.schemas.get(record.schemaId)?.name,
      encoding: record.messageEncoding,
      messages,
      metadata: Object.fromEntries(record.metadata),
    })),
    attachments: contents.attachments,
    metadata: contents.metadata,
    first: contents.first,
  };
}

function plain(_key, value) {
  if (typeof value === "bigint") return Number(value);
  if (ArrayBuffer.isView(value)) return { length: value.length, first: [...value.subarray(0, 240)] };
  return value;
}

async function main() {
  if (process.argv.length !== 3) {
    console.error("usage: node read_mcap.mjs FILE");
    return 2;
  }
  let found = {};
  const errors = [];
  try {
    const bytes = new Uint8Array(readFileSync(process.argv[2]));
    const contents = readThrough(bytes);
    found = describe(contents);
    checkProfile(contents);
    await readByIndex(bytes, contents);
  } catch (error) {
    errors.push(error.message);
  }
  console.log(JSON.stringify({ ...found, errors }, plain, 1));
  return errors.length === 0 ? 0 : 1;
}

process.exitCode = await main();
