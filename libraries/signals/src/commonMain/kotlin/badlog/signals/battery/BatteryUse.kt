package badlog.signals.battery

import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.recording.Topic
import badlog.expression.LogViewSignals
import badlog.signals.LogShape
import badlog.signals.NamedSamples
import badlog.signals.NamedSignal
import badlog.signals.vocabulary.SignalTopic
import badlog.signals.vocabulary.SignalVocabulary

/**
 * The facts in a log about the battery that was in the robot. Each property is null if the log does not show it.
 *
 * @property name the battery's name in the log.
 * @property topic the topic of its voltage.
 * @property lowest the lowest voltage, in volts.
 * @property restBefore the voltage at rest before the robot was enabled for the first time, in volts.
 * @property restAfter the voltage at rest after it was enabled for the last time, in volts.
 * @property energy the energy that the robot took from it, in watt-hours.
 * @property resistance the resistance of battery and wiring.
 * @property isBrownedOut whether the robot's computer cut outputs while enabled because the voltage was too low.
 */
data class BatteryUse(
    val name: String? = null,
    val topic: String? = null,
    val lowest: Double? = null,
    val restBefore: Double? = null,
    val restAfter: Double? = null,
    val energy: Double? = null,
    val resistance: Resistance? = null,
    val isBrownedOut: Boolean = false,
)

/** Returns the facts in [view] about its battery, found by [vocabulary]; null if there are none. */
fun batteryUseOf(view: LogView, vocabulary: SignalVocabulary): BatteryUse? {
    val shape = LogShape.of(view)
    val topics = shape.topicsOf(vocabulary)
    val name = batteryNameIn(view.recording, vocabulary)
    val voltage = topics.of("battery").firstOrNull() ?: return name?.let { BatteryUse(it) }
    val use = BatteryUse(name, voltage.topic, lowestVoltage(view.recording.topics, voltage))
    if (!shape.vocabulary.hasTime) return use
    val samples = NamedSamples(LogViewSignals(view), view)
    val series = BatterySeries.of(view, topics, samples) ?: return use
    val enabled = series.enabled
    return use.copy(
        restBefore = enabled.firstOrNull()?.let { series.atRest(Span(it.from - REST, it.from)) },
        restAfter = enabled.lastOrNull()?.takeIf { it.to + SETTLING < series.end }?.let {
            series.atRest(Span(maxOf(it.to + SETTLING, series.end - REST), series.end))
        },
        energy = series.energy(),
        resistance = series.resistance(),
        isBrownedOut = topics.of("brownout").ifEmpty { null }?.any { flag ->
            val flags = samples.of(NamedSignal.of("brownout", listOf(flag)))
            val isEnabled = samples.enabledAt(flags.x)
            flags.y.indices.any { isEnabled[it] && flags.y[it] > 0 }
        } ?: series.isLow(),
    )
}

/** Returns the lowest voltage above 0. A sensor returns 0 before it is read for the first time; no battery of a running robot has that. */
private fun lowestVoltage(topics: List<Topic>, battery: SignalTopic): Double? {
    var lowest = Double.POSITIVE_INFINITY
    for (voltage in topics.first { it.name == battery.topic }.samples) if (voltage > 0 && voltage < lowest) lowest = voltage
    return lowest.takeIf { it.isFinite() }?.let { it * (battery.scale ?: 1.0) }
}

/** The seconds before a match, and at the log's end, over which the voltage at rest is measured. */
private const val REST = 10.0

/** A battery's voltage recovers after a load; in seconds. */
private const val SETTLING = 5.0
