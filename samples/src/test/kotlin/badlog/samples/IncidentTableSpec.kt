package badlog.samples

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.rules.BUILT_IN
import badlog.rules.BUILT_IN_PROVEN
import badlog.rules.RuleSet
import badlog.rules.SignalsFile
import badlog.rules.incident.incidentsIn
import badlog.rules.over
import badlog.samples.fault.Fault
import badlog.samples.fault.FaultyMatch
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThanOrEqual
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import java.io.File

/** The name that the first incident must have for each planted fault. */
private val CAUSES = mapOf(
    Fault.WALL to "The robot pushed against something that did not move",
    Fault.LOOSE_LEAD to "Battery lead, connector or main breaker made bad contact",
    Fault.TIRED_BATTERY to "The battery was old or worn",
    Fault.SEIZED_MOTOR to "A motor was blocked",
    Fault.SEIZED_DRIVE to "A gearbox of the drivetrain was stuck",
    Fault.UNPLUGGED_MOTOR to "One of two linked motors did nothing",
    Fault.PULLED_ENCODER to "An encoder stopped reporting",
    Fault.CAN_CUT to "The CAN bus was interrupted",
    Fault.RADIO_REBOOT to "The robot lost its radio or driver station",
    Fault.SLOW_VISION to "Vision blocked the loop",
    Fault.RESTART to "The robot code restarted during the match",
)

/** A match, and the fault that its first incident names; null for none. */
private class Diagnosis(val match: FaultyMatch, val cause: String?) {
    val named: Fault? = CAUSES.entries.find { it.value == cause }?.key
    val isOther = cause != null && named == null
    val isRight = !isOther && (named == match.fault || (named != null && named == match.second))
}

/** Returns the first incidents of the matches of [seeds], to which no rule was fitted. */
private fun diagnoses(seeds: IntRange): List<Diagnosis> = seeds.toList().parallelStream().map { seed ->
    val match = FaultyMatch.of(seed)
    val rules = RuleSet.BUILT_IN_PROVEN.with(RuleSet.BUILT_IN.signals.with(SignalsFile.parse(match.signals)))
    val view = LogView.of(BagParser().apply { accept(match.bag()) }.finish())
    Diagnosis(match, rules.incidentsIn(rules.over(view, "$seed.bag").findings).firstOrNull()?.name)
}.toList()

private fun table(diagnoses: List<Diagnosis>): String {
    val columns = Fault.entries.map { it.title } + "other" + "none"
    val rows = (Fault.entries + null).map { fault ->
        val matches = diagnoses.filter { it.match.fault == fault }
        val counts = Fault.entries.map { named -> matches.count { it.named == named } } + matches.count { it.isOther } +
            matches.count { it.cause == null }
        "| ${fault?.title ?: "nothing"} | ${counts.joinToString(" | ") { if (it == 0) "" else "$it" }} |"
    }
    val head = "| planted | ${columns.joinToString(" | ")} |\n|---|${"---|".repeat(columns.size)}"
    return (listOf(head) + rows).joinToString("\n")
}

class IncidentTableSpec : FunSpec({
    val (faint, others) = diagnoses(101..300).partition { it.match.isFaint }
    val (double, clear) = others.partition { it.match.second != null }

    test("the first incident names the planted fault in nine of ten matches, another one in one at most, and a healthy match has none") {
        for (fault in Fault.entries) {
            val matches = clear.filter { it.match.fault == fault }
            // A battery with a single brownout under a load that a sensor shows too late looks like a good one. The rules are silent.
            val least = if (fault == Fault.TIRED_BATTERY) 8 else 9
            withClue(fault.title) {
                10 * matches.count { it.isRight } shouldBeGreaterThanOrEqual least * matches.size
                10 * matches.count { it.cause != null && !it.isRight } shouldBeLessThanOrEqual matches.size
            }
        }
        (clear + faint).filter { it.match.fault == null }.mapNotNull { it.cause } shouldBe emptyList()
    }

    test("of two faults in one match, the first incident names one in eight of ten") {
        10 * double.count { it.isRight } shouldBeGreaterThanOrEqual 8 * double.size
    }

    test("the guide's table of planted and named faults is current; BADLOG_WRITE_GUIDE rewrites it") {
        val guide = File("../docs/rules.md")
        val written = guide.readText()
        val made = written.substringBefore(BEGIN) + BEGIN + "\n" + table(clear) + "\n\nOf ${double.size} matches with two of these faults, the first incident " +
            "names one of them in ${double.count { it.isRight }}.\n\nWhere a fault was so faint, or came so late, that a " +
            "log may not show it:\n\n" + table(faint) + "\n" + END + written.substringAfter(END)
        if (System.getenv("BADLOG_WRITE_GUIDE") != null) guide.writeText(made) else made shouldBe written
    }
})

private const val BEGIN = "<!-- incidents begin -->"
private const val END = "<!-- incidents end -->"
