package badlog.rules.pack

import badlog.core.json.JsonMember
import badlog.core.json.JsonReader
import badlog.core.json.JsonValue
import badlog.rules.DeviceNames
import badlog.rules.NamedDevice
import badlog.rules.RulesException

/**
 * A team's file with the devices on its CAN bus, in one of the ways that teams write it:
 *
 * - a list of objects with an id, a name, and perhaps a subsystem and a type;
 * - an object from ids to names, or to such objects: `{"3": "Front left drive", "CANcoder-3": {"name": "Front left encoder"}}`;
 * - an object from names to ids, perhaps by subsystem: `{"Drive": {"Front left": 3}}`;
 * - one of these as the member `devices` of an object.
 */
internal object DeviceMap {
    /** The name of such a file. */
    const val NAME = "can_map.json"

    /**
     * Reads [text].
     *
     * @throws RulesException if it is not such a list.
     */
    fun parse(text: String): DeviceNames {
        // A list is read as a member, since the reader wants an object.
        val root = JsonReader.readObject("{\"devices\":$text}")?.singleOrNull()?.value
            ?: throw RulesException(1, "It is not JSON; look for a missing comma, quote or bracket.")
        val listed = root.members?.find { folded(it.key) == "devices" }?.value
        val devices = if (listed == null) devicesIn(root, subsystem = "") else devicesIn(listed, subsystem = "") + namedIn(root)
        if (devices.isEmpty()) {
            throw RulesException(
                1,
                "It lists no device; write each as {\"id\": 3, \"name\": \"Front left drive\", \"subsystem\": \"Drive\"}.",
            )
        }
        return DeviceNames(devices)
    }

    /** Returns the devices that members of [root] name beside its list. */
    private fun namedIn(root: JsonValue) = root.members.orEmpty().filter { it.value.text != null }.flatMap { devicesOf(it, subsystem = "") }

    private fun devicesIn(value: JsonValue, subsystem: String): List<NamedDevice> {
        val items = value.items
        if (items != null) return items.mapNotNull { item -> item.members?.let { deviceOf(it, null, null, subsystem) } }
        return value.members.orEmpty().flatMap { member -> devicesOf(member, subsystem) }
    }

    private fun devicesOf(member: JsonMember, subsystem: String): List<NamedDevice> {
        val address = Address.of(member.key)
        val text = member.value.text
        val id = idIn(member.value)
        val members = member.value.members
        return when {
            address != null && text != null -> listOf(NamedDevice(address.type, address.id, text, subsystem))
            id != null -> listOf(NamedDevice("", id, member.key, subsystem))
            members == null -> devicesIn(member.value, subsystem = member.key)
            else -> deviceOf(members, address, member.key, subsystem)?.let(::listOf) ?: devicesIn(member.value, subsystem = member.key)
        }
    }

    /** Returns the device that [members] of [key] describe. Null if neither they nor [address] have an id, or if it has no name. */
    private fun deviceOf(members: List<JsonMember>, address: Address?, key: String?, subsystem: String): NamedDevice? {
        fun textOf(keys: Set<String>) =
            members.firstNotNullOfOrNull { member -> member.value.text?.takeIf { it.isNotBlank() && folded(member.key) in keys } }
        val written = members.find { folded(it.key) in IDS }?.value
        val ownAddress = written?.let { value -> idIn(value)?.let { Address("", it) } ?: value.text?.let(Address::of) }
        val known = ownAddress ?: address ?: return null
        val name = textOf(NAMES) ?: key.takeIf { ownAddress != null } ?: return null
        return NamedDevice(textOf(TYPES) ?: known.type, known.id, name, textOf(SUBSYSTEMS) ?: subsystem)
    }

    private fun idIn(value: JsonValue): Int? = value.json.toIntOrNull()?.takeIf { it >= 0 }

    /** A type and an id as written: `CTRE:TalonFX-2`, `SPARK:16`, `Pigeon2-30`, `16`. */
    private class Address(val type: String, val id: Int) {
        companion object {
            private val FORM = Regex("(?:([^:]*):)?(.*?)[-: _#]*(\\d{1,4})")
            private val NO_TYPES = setOf("", "id", "can", "canid", "device")

            fun of(text: String): Address? {
                val (maker, type, id) = FORM.matchEntire(text.trim())?.destructured ?: return null
                return Address(type.ifEmpty { maker }.takeIf { folded(it) !in NO_TYPES }.orEmpty(), id.toInt())
            }
        }
    }

    private fun folded(text: String) = text.lowercase().filter { it.isLetterOrDigit() }

    private val IDS = setOf("id", "canid", "deviceid", "address", "number")
    private val NAMES = setOf("name", "label", "description")
    private val SUBSYSTEMS = setOf("subsystem", "mechanism", "system")
    private val TYPES = setOf("type", "devicetype", "kind", "model", "controller")
}
