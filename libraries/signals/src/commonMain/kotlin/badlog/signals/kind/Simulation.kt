package badlog.signals.kind

import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.signals.vocabulary.SignalTopics
import kotlin.math.abs
import kotlin.math.round

/**
 * Returns why [recording] must be from a simulated robot, as part of a sentence. Null for a real robot, and if nothing shows it. An example
 * is `its battery had exactly 12 V throughout`. The evidence is its metadata, the FPGA of WPILib's simulation, dashboards that all ran on
 * the same computer, its battery, or currents that nothing measured. WPILib's `RoboRioSim` begins with exactly 12 V, and `BatterySim`
 * subtracts from it; no measured battery behaves like that.
 *
 * @param topics the signals of the log.
 */
fun simulationIn(recording: Recording, topics: SignalTopics): String? =
    metadataIn(recording) ?: fpgaIn(recording) ?: clientsIn(recording) ?: batteryIn(recording, topics) ?: memoryIn(recording, topics)

/** Returns the topics among [names] that decide whether a log is of a simulated robot, besides its battery. */
fun namesOfKind(names: List<String>): List<String> = names.filter { saysKind(it) || it.endsWith(FPGA) || it == CLIENTS }

private fun metadataIn(recording: Recording): String? {
    for (value in recording.values) {
        if (saysKind(value.name) && isSimulated(value.text)) return "its ${lastWord(value.name)} is ${value.text.trim()}"
    }
    for (topic in recording.topics) {
        if (!saysKind(topic.name)) continue
        val text = (0 until topic.texts.size).map { topic.texts[it] }.firstOrNull(::isSimulated) ?: continue
        return "its ${lastWord(topic.name)} is ${text.trim()}"
    }
    return null
}

// A replay in a simulation has the inputs of a real robot.
private fun saysKind(name: String) = lastWord(name).lowercase() in NAMES && "ReplayMetadata" !in name

private fun isSimulated(text: String) = SIMULATED.matches(text.trim())

private fun lastWord(name: String) = name.substringAfterLast('/')

private fun fpgaIn(recording: Recording): String? {
    val versions = recording.topics.find { it.name.endsWith(FPGA) }?.let(::numbersOf).orEmpty()
    return "its FPGA is the one of WPILib's simulation".takeIf { versions.isNotEmpty() && versions.all { it == SIMULATED_FPGA } }
}

private fun clientsIn(recording: Recording): String? {
    val texts = recording.topics.find { it.name == CLIENTS }?.texts ?: return null
    val addresses = (0 until texts.size).mapNotNull { ADDRESS.find(texts[it])?.groupValues?.get(1) }
    return "its dashboards ran on the computer that it ran on".takeIf { addresses.isNotEmpty() && addresses.all(::isLocal) }
}

private fun isLocal(address: String) = address == "127.0.0.1" || address == "::1"

private fun batteryIn(recording: Recording, topics: SignalTopics): String? {
    val found = topics.of("battery").firstOrNull() ?: return null
    // The Driver Station's own measurement has few steps; one of them is 12 V.
    if ("DSLog" in found.topic || MEASURED.none { it in found.topic.lowercase() }) return null
    val volts = recording.topics.find { it.name == found.topic }?.let(::numbersOf).orEmpty()
    if (volts.isEmpty() || volts.any { it > NOMINAL }) return null
    // AdvantageKit logs changes; in others, a single sample may be the start of something that was never measured.
    if (volts.size == 1 && "SystemStats" !in found.topic) return null
    val resting = volts.count { it == NOMINAL }
    return when {
        resting == volts.size -> "its battery had exactly 12 V throughout"
        resting > volts.size * MIN_RESTING && volts.any(::isCalculated) -> "its battery rested at exactly 12 V"
        else -> null
    }
}

/** A power distribution that no device stands for. Its currents are memory that was never written, and its voltage is 12 V or none. */
private fun memoryIn(recording: Recording, topics: SignalTopics): String? {
    fun numbersOf(signal: String) =
        topics.of(signal).firstOrNull()?.topic?.let { name -> recording.topics.find { it.name == name } }?.let(::numbersOf).orEmpty()
    val volts = numbersOf("battery")
    val isSet = NOMINAL in volts && volts.all { it == NOMINAL || it == 0.0 }
    return "its currents were never measured, and its battery had exactly 12 V or none".takeIf {
        isSet && numbersOf("channel current").any { it != 0.0 && abs(it) < UNWRITTEN }
    }
}

private fun numbersOf(topic: Topic) = topic.samples.filter { it.isFinite() }

/** Returns whether [volts] has more than two decimals; a program that rounds its values may meet 12 V by chance. */
private fun isCalculated(volts: Double) = abs(volts * HUNDREDTHS - round(volts * HUNDREDTHS)) > ROUNDED

private const val FPGA = "SystemStats/FPGAVersion"
private const val CLIENTS = "NTConnection"

/** The names of a measured voltage of the battery; others may be constants. */
private val MEASURED = listOf("battery", "powerdistribution", "pdp", "pdh")
private val NAMES =
    setOf("runtimetype", "runtime type", "robotmode", "robot mode", "mode", "robot", "robottype", "robot type", "environment")
private val SIMULATED = Regex("k?sim(bot|ulation|ulated|ulator)?", RegexOption.IGNORE_CASE)
private val ADDRESS = Regex("\"remote_ip\":\"([^\"]*)\"")

/** The type of a robot in the simulation of WPILib's HAL. A roboRIO's is the year of its image in hexadecimal digits, such as 0x2024. */
private const val SIMULATED_FPGA = 2018.0
private const val NOMINAL = 12.0
private const val MIN_RESTING = 0.02
private const val HUNDREDTHS = 100
private const val ROUNDED = 1e-4

/** Bits of addresses, read as numbers, are smaller than any current, in A. */
private const val UNWRITTEN = 1e-100
