// Prints the messages in the bytes of standard input as JSON, a line each, as node-mavlink decodes them.
import { MavLinkPacketParser, MavLinkPacketSplitter, common, minimal } from 'node-mavlink'

const registry = { ...minimal.REGISTRY, ...common.REGISTRY }
// NaN is no JSON, and a bigint neither.
const plain = (_, value) => (typeof value === 'bigint' ? String(value) : Number.isNaN(value) ? 'NaN' : value)
process.stdin
  .pipe(new MavLinkPacketSplitter())
  .pipe(new MavLinkPacketParser())
  .on('data', (packet) => {
    const type = registry[packet.header.msgid]
    if (!type) return
    const fields = packet.protocol.data(packet.payload, type)
    console.log(JSON.stringify({ name: type.MSG_NAME, system: packet.header.sysid, component: packet.header.compid, fields }, plain))
  })
