package badlog.samples

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.rules.comparison.compared
import badlog.rules.comparison.numbersOf
import badlog.rules.number.LogNumbers
import badlog.samples.fault.Fault
import badlog.samples.fault.FaultyMatch
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith

/** Tests of comparisons between the matches of a season: a fault planted in one match is found only there. */
class SeasonSpec : FunSpec({
    fun viewOf(seed: Int, fault: Fault? = null) = LogView.of(BagParser().apply { accept(FaultyMatch(seed, fault, isFaint = false).bag()) }.finish())

    fun numbersOf(view: LogView): LogNumbers = numbersOf(view, RuleSet.BUILT_IN.signals, "match.bag")

    val season = (401..430).toList().parallelStream().map { numbersOf(viewOf(it)) }.toList()

    fun findingsOf(logs: List<LogNumbers>) = RuleSet.BUILT_IN.compared(logs).map { log -> log.findings.map { "${it.rule}: ${it.text}" } }

    /** Returns match [seed] with the values of the topic [name] multiplied by [factor]. */
    fun scaled(seed: Int, name: String, factor: Double): LogNumbers {
        val recording = viewOf(seed).recording
        val topics = recording.topics.map { topic ->
            if (topic.name == name) topic.copy(samples = DoubleArray(topic.samples.size) { topic.samples[it] * factor }) else topic
        }
        return numbersOf(LogView.of(recording.copy(topics = topics)))
    }

    test("a healthy season of thirty matches has no finding") {
        findingsOf(season).flatten().shouldBeEmpty()
    }

    test("a motor that draws more than in the other matches is found, with the phase in which it does") {
        val odd = scaled(500, "Drivetrain/Left Current", 2.0)
        val found = findingsOf(season.take(15) + odd + season.drop(15))
        found[15].single() shouldStartWith "Unlike other matches: Drivetrain/Left Current "
        found[15].single() shouldContain " % above your 20 other matches (usually "
        (found - setOf(found[15])).flatten().shouldBeEmpty()
    }

    test("a tired battery has a higher resistance than in the other matches") {
        val tired = numbersOf(viewOf(500, Fault.TIRED_BATTERY))
        tired.resistance shouldBeGreaterThan 1.4 * season.map { it.resistance }.average()
        findingsOf(season + tired).last().map { it.substringBefore(':') } shouldContain "Resistance above other matches"
    }

    test("one outlier among the matches does not affect the others") {
        val withOutlier = season[0].keys.map { it.topic }.distinct().fold(viewOf(501).recording) { recording, name ->
            recording.copy(
                topics = recording.topics.map { topic ->
                    if (topic.name == name) topic.copy(samples = DoubleArray(topic.samples.size) { topic.samples[it] * 50 }) else topic
                },
            )
        }
        val found = findingsOf(season.take(10) + numbersOf(LogView.of(withOutlier)) + season.drop(10))
        found.filterIndexed { place, _ -> place != 10 }.flatten().shouldBeEmpty()
    }

    test("with only four other matches, no match is compared") {
        findingsOf(season.take(4) + scaled(500, "Drivetrain/Left Current", 5.0)).flatten().shouldBeEmpty()
        findingsOf(season.take(5) + scaled(500, "Drivetrain/Left Current", 9.0)).last().size shouldBe 1
    }
})
