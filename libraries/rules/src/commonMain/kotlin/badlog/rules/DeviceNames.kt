package badlog.rules

import badlog.core.json.JsonValue
import badlog.core.json.quotedJson
import badlog.signals.derived.BusAddress
import badlog.signals.derived.busDeviceIn
import badlog.signals.json.JsonFields
import badlog.signals.json.jsonObject
import badlog.signals.vocabulary.NamePattern

/**
 * A device on the CAN bus, with a team's name for it.
 *
 * @property type its type, such as `TalonFX` or `motor`; empty if the team does not give it.
 * @property id its id on the bus.
 * @property name its name, such as `Front left drive`.
 * @property subsystem the part of the robot that it belongs to; empty if the team does not give it.
 */
class NamedDevice(val type: String, val id: Int, val name: String, val subsystem: String) {
    /** Whether it has no type, so that any type of device with its id matches. */
    internal val isOfAnyType: Boolean get() = type.isEmpty()

    internal fun isOf(address: BusAddress): Boolean {
        if (id != address.id) return false
        val actual = NamePattern.folded(address.type)
        val wanted = NamePattern.folded(type)
        return when {
            wanted == "encoder" -> actual == ENCODER
            MOTORS.any(wanted::startsWith) -> actual != ENCODER
            else -> actual.startsWith(wanted) || wanted.startsWith(actual)
        }
    }

    private companion object {
        const val ENCODER = "cancoder"

        /** Teams name the motor, logs its controller. */
        val MOTORS = listOf("motor", "falcon", "kraken", "neo", "vortex")
    }
}

/** A team's names for the [devices] on its CAN bus; logs name them by their types and ids. */
class DeviceNames(val devices: List<NamedDevice>) {
    /**
     * Returns the text for [device], which is its name in logs. A name that the team gave it comes first:
     * `Front left drive (Drive, TalonFX 3)`.
     */
    internal fun deviceText(device: String): String {
        val named = find(device) ?: return device
        val address = BusAddress.of(device)?.let { "${it.type} ${it.id}" }
        return "${named.name} (${listOfNotNull(named.subsystem.ifEmpty { null }, address).joinToString()})"
    }

    /** Returns [topic], followed by the name of its device if that has one. */
    internal fun topicText(topic: String): String {
        val named = if (devices.isEmpty()) null else busDeviceIn(topic)?.let(::find)
        return if (named == null) topic else "$topic (${named.name})"
    }

    /** Returns the entry for [device]. If several devices have the same id, the type must show which one is meant. */
    private fun find(device: String): NamedDevice? {
        if (devices.isEmpty()) return null
        val address = BusAddress.of(device) ?: return null
        val fitting = devices.filter { it.isOf(address) }
        return fitting.singleOrNull() ?: fitting.singleOrNull { !it.isOfAnyType }
    }

    companion object {
        val NONE: DeviceNames = DeviceNames(emptyList())
    }
}

internal fun deviceJson(device: NamedDevice): String = jsonObject(
    "type" to device.type.takeIf { it.isNotEmpty() }?.let(::quotedJson),
    "id" to device.id.toString(),
    "name" to quotedJson(device.name),
    "subsystem" to device.subsystem.takeIf { it.isNotEmpty() }?.let(::quotedJson),
)

internal fun deviceOf(value: JsonValue): NamedDevice {
    val json = JsonFields(value.members)
    return NamedDevice(json.optional("type").orEmpty(), json.number("id"), json.string("name"), json.optional("subsystem").orEmpty())
}
