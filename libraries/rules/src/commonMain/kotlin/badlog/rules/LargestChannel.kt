package badlog.rules

import badlog.core.analysis.Span
import badlog.rules.number.meanOf
import badlog.rules.number.timeWithin
import badlog.signals.NamedSamples
import badlog.signals.NamedSignal

/** A channel of the power distribution, and its mean current. */
internal class LargestChannel(val topic: String, val amperes: Double)

/**
 * Returns the [channels] with the largest mean currents within [spans], the largest first, at most [MAX_CHANNELS]. [end] is the end of the
 * log.
 */
internal fun largestChannels(channels: List<NamedSignal>, spans: List<Span>, samples: NamedSamples, end: Double): List<LargestChannel> {
    if (channels.isEmpty() || spans.isEmpty()) return emptyList()
    val ordered = spans.sortedBy { it.from }
    return channels.mapNotNull { channel ->
        val series = samples.of(channel)
        val amperes = if (series.isOrdered) meanOf(series, timeWithin(ordered, series.x, end), least = 0.0) else Double.NaN
        if (amperes > MIN_AMPERES) LargestChannel(channel.topics.first(), amperes) else null
    }.sortedByDescending { it.amperes }.take(MAX_CHANNELS)
}

private const val MAX_CHANNELS = 4

/** The current of a channel that does nothing, in amperes. */
private const val MIN_AMPERES = 2.0
