package badlog.samples.generated

import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.Topic
import badlog.formats.wpilog.WpilogFormat
import badlog.samples.generated.fault.Fault
import badlog.samples.generated.fault.Naming
import badlog.samples.generated.fault.Visibility
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.scopes.FunSpecRootScope
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import kotlin.math.abs

internal val GENERATOR = MatchGenerator(2026)

/** Returns a topic's difference between [from] and [until], as a share of its range in the match without the fault; texts differ by 1. */
private fun difference(one: HeldSamples, other: HeldSamples, from: Double, until: Double): Double {
    var sum = 0.0
    var count = 0
    var least = Double.POSITIVE_INFINITY
    var most = Double.NEGATIVE_INFINITY
    var time = from
    while (time < until) {
        val a = one.at(time)
        val b = other.at(time)
        if (!b.isNaN()) {
            least = minOf(least, b)
            most = maxOf(most, b)
        }
        if (!a.isNaN() || !b.isNaN()) {
            sum += if (a.isNaN() || b.isNaN()) 1.0 else abs(a - b)
            count++
        }
        time += 0.1
    }
    return if (count == 0) 0.0 else sum / count / maxOf(most - least, 1e-3)
}

/** Returns a contradiction between the log [with] the fault of [match] and the table of faults; null if there is none. */
private fun contradictionIn(match: GeneratedMatch, with: Recording): String? {
    val fault = checkNotNull(match.fault)
    val start = checkNotNull(match.start)
    val isSeen = fault.sightIn(match.naming).visibility != Visibility.NOTHING
    if (match.evidence.isEmpty() == isSeen) return "the evidence is ${match.evidence}"
    val without = recordingOf(MatchGenerator.withoutFault(match))
    val others = without.topics.associateBy { it.name }
    fun changeOf(topic: Topic, from: Double, until: Double) = others[topic.name]?.let { difference(HeldSamples(with, topic), HeldSamples(without, it), from, until) } ?: 1.0
    // Heat and a hard pull precede their effects.
    val quiet = if (fault.id == "hot-motor") 0.0 else start - 7
    with.topics.find { it.name in others && changeOf(it, 0.0, quiet) != 0.0 }?.let { return "“${it.name}” differs before the fault starts" }
    if (!isSeen) return null
    val shown = with.topics.filter { topic -> match.evidence.any { topic.name == it || topic.name.startsWith("$it/") || topic.name.startsWith("$it[") } }
    val most = shown.maxOfOrNull { changeOf(it, start, start + 120) } ?: 0.0
    return if (most > 0.01) null else "its evidence ${match.evidence} differs by $most of its range only"
}

/** Returns the recording of [match], which is read without a problem. */
internal fun read(match: GeneratedMatch): Recording = withClue(match.name) {
    val recording = recordingOf(match)
    recording.format shouldBe if (match.naming.isBag) RecordingFormat.BAG else WpilogFormat
    recording.problems.shouldBeEmpty()
    recording.topics.filter { it.size == 0 }.map { it.name }.filterNot { "Console" in it || it == "messages" }.shouldBeEmpty()
    recording.topics.map { it.name }.toSet().size shouldBe recording.topics.size
    recording
}

/** Adds a test that [faults] in logs of [naming] show in their evidence, and nowhere before they start. */
internal fun FunSpecRootScope.testFaults(naming: Naming, faults: List<Fault>) {
    test("logs of ${naming.id} are read; each fault changes a topic of its evidence, and nothing before it starts") {
        faults.mapNotNull { fault ->
            val match = GENERATOR.faulty(naming, fault, 1.0)
            contradictionIn(match, read(match))?.let { "$fault: $it" }
        }.shouldBeEmpty()
    }
}
