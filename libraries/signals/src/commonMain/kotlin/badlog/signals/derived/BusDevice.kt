package badlog.signals.derived

import badlog.expression.signals.Signal
import badlog.signals.vocabulary.NamePattern

/** The values that devices on the CAN bus report about themselves, by all vendors' names. */
enum class BusSignal(vararg val names: String) {
    POSITION("position", "primaryencoderposition"),
    VELOCITY("velocity", "primaryencodervelocity"),
    OUTPUT("dutycycle", "appliedoutput"),
    CURRENT("statorcurrent", "current", "outputcurrent"),
    SUPPLY_CURRENT("supplycurrent"),
    REFERENCE("closedloopreference"),
    ERROR("closedlooperror"),
    ABSOLUTE("absoluteposition", "dutycycleencoderposition", "externaloraltencoderposition"),

    /** True while a limit switch is pressed. */
    PRESSED("hardreverselimitreached", "hardforwardlimitreached"),

    /** 0 while a limit switch closes its circuit. */
    OPEN("reverselimit", "forwardlimit"),
}

/**
 * A device on the CAN bus with topics named by its type and its id, as in `Phoenix6/TalonFX-3/StatorCurrent`. Nothing shows which part it
 * moves.
 *
 * @property label its name for people, such as `TalonFX 3`.
 */
class BusDevice internal constructor(val label: String, private val topics: Map<BusSignal, String>) {
    /** The full names of its topics, without other devices' topics. */
    val names: List<String> get() = topics.values.toList()

    internal val id: Int get() = label.filter { it in '0'..'9' }.toInt()

    /** Whether it is a motor that reports its velocity and its current. */
    val isMotor: Boolean get() = BusSignal.VELOCITY in topics && BusSignal.CURRENT in topics

    fun topic(signal: BusSignal): String? = topics[signal]

    operator fun contains(signal: BusSignal): Boolean = signal in topics
}

/** Returns the beginning of [name] that all topics of its device share, such as `Phoenix6/TalonFX-3`. Null if [name] is not of a device. */
fun busDeviceIn(name: String): String? {
    val start = startOfDevice(name)
    return if (start < 0) null else name.substring(0, endOfDevice(name, start))
}

/**
 * The type and id by which topics and findings name a device. `Phoenix6/TalonFX-3` and `TalonFX 3` are the type `TalonFX` with the id 3.
 *
 * @property type its type.
 * @property id its id on the CAN bus.
 */
class BusAddress private constructor(val type: String, val id: Int) {
    companion object {
        /** Returns the address in [device], a device's label or the common beginning of its topics; null if it has none. */
        fun of(device: String): BusAddress? {
            val label = device.substringAfterLast('/')
            val digits = label.indexOfFirst { it in '0'..'9' }
            if (digits <= 0 || NamePattern.folded(label.substring(0, digits)) !in TYPES) return null
            val id = label.substring(digits).takeWhile { it in '0'..'9' }.toIntOrNull() ?: return null
            return BusAddress(label.substring(0, digits).trimEnd('-', ' ', '_'), id)
        }
    }
}

/** Returns the devices among [names], in order. */
internal fun busDevicesOf(names: List<Signal>): List<BusDevice> = names.groupBy { busDeviceIn(it.name) }.mapNotNull { (path, signals) ->
    val label = path?.substringAfterLast('/') ?: return@mapNotNull null
    val topics = LinkedHashMap<BusSignal, String>()
    for (signal in signals) {
        val own = NamePattern.folded(signal.name.substringAfterLast('/'))
        BusSignal.entries.find { own in it.names }?.let { if (it !in topics) topics[it] = signal.name }
    }
    val kind = if (label.startsWith("CANcoder", ignoreCase = true)) " (an absolute encoder)" else ""
    BusDevice(label.replace('-', ' ') + kind, topics).takeIf { topics.isNotEmpty() }
}

private fun startOfDevice(name: String): Int {
    var start = 0
    while (start >= 0) {
        if (endOfDevice(name, start) > start) return start
        start = name.indexOf('/', start) + 1
        if (start == 0) break
    }
    return -1
}

/** Returns the end of the type and id of a device that begin in [name] at [start]. Returns [start] if none does. */
private fun endOfDevice(name: String, start: Int): Int {
    val digits = (start until name.length).firstOrNull { name[it] in '0'..'9' } ?: return start
    if (NamePattern.folded(name.substring(start, digits)) !in TYPES) return start
    return name.indexOf('/', digits).let { if (it < 0) start else it }
}

private val TYPES = setOf("talonfx", "talonfxs", "talonsrx", "victorspx", "spark", "sparkmax", "sparkflex", "cancoder")
