package badlog.viewer.shown.folder

import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.rules.fromJson
import badlog.rules.number.LogNumbers
import badlog.rules.number.LogNumbersReader
import badlog.rules.number.LogNumbersText
import badlog.rules.number.Measure
import badlog.rules.toJson
import badlog.signals.match.MatchKind
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogSummary
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

class ChangesSpec : FunSpec({
    fun log(name: String, second: Long) = AnyLog(name, LogSummary(date = LogDate(second, DateSource.VALUES), content = Content.SOMETHING), FindingSummary(0, emptyList()))

    /** A log with a motor as hot as [celsius]. */
    fun numbers(celsius: Double, kind: MatchKind = MatchKind.MATCH, motor: String = "Arm"): LogNumbers = LogNumbersReader().read(
        LogNumbersText(
            "motor temperature\t$motor/Temperature\t${Measure.HIGHEST.ordinal}\t°C",
            "${kind.ordinal};NaN;false;false;$celsius",
        ),
    )

    // Pages have their rules as JSON.
    val rules = checkNotNull(RuleSet.fromJson(RuleSet.BUILT_IN.toJson()))
    val logs = List(8) { log("$it.bag", it.toLong()) }

    test("a log that is unlike the matches before it has differences") {
        val temperatures = listOf(41.0, 40.0, 42.0, 39.5, 41.5, 40.5, 95.0)
        val changes = changesOf(logs[6], logs.take(6), rules) { numbers(temperatures[logs.indexOf(it)]) }
        changes.differences.single().text shouldContain "Arm/Temperature at its highest was 95 °C"
        changes.previous[changes.differences.single()] shouldBe logs[5]
    }

    test("a log like the others, or with too few before it, has no differences") {
        changesOf(logs[6], logs.take(6), rules) { numbers(40.0 + logs.indexOf(it) % 3) }.differences.shouldBeEmpty()
        changesOf(logs[3], logs.take(3), rules) { numbers(if (it === logs[3]) 95.0 else 40.0) }.differences.shouldBeEmpty()
        changesOf(logs[0], emptyList(), rules) { numbers(95.0) } shouldBe Changes()
        changesOf(logs[6], logs.take(6), rules) { LogNumbers.NONE } shouldBe Changes()
    }

    test("logs without common numbers, such as the Driver Station's, neither count nor are drawn over it") {
        val many = List(50) { log("$it.bag", it.toLong()) }
        val changes = changesOf(many[49], many.take(49), rules) {
            val place = many.indexOf(it)
            if (place % 2 == 0) numbers(30.0, motor = "Other") else numbers(if (place == 49) 95.0 else 40.0 + place % 3)
        }
        val difference = changes.differences.single()
        difference.text shouldContain "your 20 other matches"
        changes.previous shouldBe mapOf(difference to many[47])
    }

    test("only the last 20 matches before count, neither practice nor another log of the same match") {
        val many = List(40) { log("$it.bag", it.toLong()) }
        earlierThan(many[25], many.shuffled()).map { it.summary.date.second } shouldBe (0L..24L).toList()
        val match = MatchOfLog(null, "Qualification", "7")
        fun AnyLog.of(match: MatchOfLog) = copy(summary = summary.copy(match = match))
        earlierThan(many[1].of(match), listOf(many[0].of(match))).shouldBeEmpty()

        var read = 0
        val changes = changesOf(many[39], many.take(39), rules) {
            read++
            if (it === many[38]) numbers(40.0, MatchKind.PRACTICE) else numbers(if (it === many[39]) 95.0 else 40.0 + read % 3)
        }
        changes.differences.single().text shouldContain "your 20 other matches"
        changes.previous[changes.differences.single()] shouldBe many[37]
    }
})
