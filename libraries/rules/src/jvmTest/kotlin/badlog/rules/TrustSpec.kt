package badlog.rules

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith

private const val CAN = "/SystemStats/CANBus/Utilization"

class TrustSpec : FunSpec({
    fun TestMatch.finding(rule: String) = findings().single { it.rule == rule }

    test("a reading that no robot has is neither a dip nor a peak, and the finding says how many were left out") {
        val match = TestMatch().apply {
            from(20.0, BATTERY) {
                when {
                    it < 20.1 -> "37.375"
                    it < 20.6 -> "6.4"
                    else -> "12"
                }
            }
        }
        match.finding("Low battery").caveats shouldBe listOf("5 samples of $BATTERY are left out: no robot has such values.")
        TestMatch().apply { from(20.0, "/DSLog/CPUUtilization") { "1.5" } }.findings().map { it.rule } shouldNotContain "CPU busy"
    }

    test("a loop time without a unit is read in s, ms or µs, as its values say") {
        for (factor in listOf(0.001, 1.0, 1000.0)) {
            val match = TestMatch().apply {
                without("/RealOutputs/LoggedRobot/FullCycleMS")
                number("Robot/Loop Time") { (if (it in 20.0..20.4) 60.0 else 9.0) * factor }
            }
            match.finding("Loop overrun").text shouldBe "The loop took too long: up to 60 ms (above 50 ms)."
        }
    }

    test("many short hits are one finding with a duration") {
        val match = TestMatch().apply { from(20.0, CAN) { if ((it * 10).toInt() % 2 == 0) "0.97" else "0.7" } }
        val rules = RulesFile.parse("[[rule]]\nname = \"A\"\nseverity = \"note\"\nwhen = \"$CAN > 0.9\"\ntext = \"{duration}\"\n").rules
        val finding = match.findings(rules).single()
        finding.spans.size shouldBe 1
        finding.spanCount shouldBe 1
        finding.spans[0].width shouldBe (19.9 plusOrMinus 0.1)
    }

    test("short hits that come in groups are few marks, and the text says how long and how often in truth") {
        val hits = setOf(0, 5, 10)
        val match = TestMatch().apply { from(0.0, "/SystemStats/CANBus/ReceiveErrorCount") { if (Math.round(it * 50).toInt() % 75 in hits) "1" else "0" } }
        val rules = RulesFile.parse(
            "[[rule]]\nname = \"A\"\nseverity = \"note\"\nwhen = \"/SystemStats/CANBus/ReceiveErrorCount > 0\"\ntext = \"{duration} ({count}×)\"\n",
        ).rules
        val finding = match.findings(rules).single()
        finding.spans.size shouldBe 1
        finding.text shouldBe "1.62 s (81×)"
    }

    test("the four channels with the highest currents are named with them, and are evidence") {
        val match = TestMatch().apply {
            for ((channel, amperes) in listOf(60, 20, 70, 40, 30).withIndex()) {
                number("/PowerDistribution/ChannelCurrent[$channel]") { if (it in 20.0..26.0) amperes.toDouble() else 3.0 }
            }
        }
        val finding = match.finding("High total current")
        fun channel(index: Int) = "/PowerDistribution/ChannelCurrent[$index]"
        finding.text shouldBe "The robot drew more than 180 A for 6.02 s, up to 220 A; " +
            "most by ${channel(2)} (70 A), ${channel(0)} (60 A), ${channel(3)} (40 A), ${channel(4)} (30 A)."
        finding.evidence.filter { "Channel" in it } shouldBe listOf(2, 0, 3, 4).map(::channel)
    }

    test("a signal that rose at the same time is called by its topic if there are several of its kind") {
        fun match(vararg cameras: String) = TestMatch().apply {
            without("Vision/Latency")
            from(20.0, "/RealOutputs/LoggedRobot/FullCycleMS") { if (it < 20.2) "160" else "9" }
            for (camera in cameras) number("Vision/$camera/Latency") { if (it in 20.0..20.2) 90.0 else 25.0 }
        }.finding("Loop blocked").text.substringAfter("at the same time, ")
        match("Left") shouldBe "vision latency rose to 90 ms from its usual 25 ms."
        match("Left", "Right") shouldBe
            "Vision/Left/Latency rose to 90 ms from its usual 25 ms and Vision/Right/Latency rose to 90 ms from its usual 25 ms."
    }

    test("a log that begins in teleop, and says how much of the match was left, has one finding of that") {
        val match = TestMatch().apply(PLANTED.getValue("Log begins in teleop")).apply { number("/DriverStation/MatchTime") { 100 - it } }
        match.findings().map { it.rule }.filter { it == "Log begins in teleop" || it == "Restarted in the match" } shouldBe listOf("Restarted in the match")
    }

    test("a part that was cut out of a match's log does not say that the program had restarted") {
        val match = TestMatch().apply(PLANTED.getValue("Restarted in the match"))
        fun restarts(clock: (Double) -> Double) = HEARD_RULES.over(match.view(clock), "test.bag").findings.count { it.rule == "Restarted in the match" }
        restarts { it + 12 } shouldBe 1
        restarts { it + 60 } shouldBe 0
    }

    test("a finding says how rarely its topic is sampled, unless that is each loop") {
        val match = TestMatch().apply { from(20.0, BATTERY) { if (it < 20.5) "6.4" else "12" } }
        match.finding("Low battery").caveats.shouldBeEmpty()
        val slow = RuleSet.BUILT_IN.over(match.view { time -> time.takeIf { (it * 50).toInt() % 5 == 0 } }, "test.bag").findings
        slow.first { it.rule == "Low battery" }.caveats shouldContain "$BATTERY is sampled every 100 ms here: what is shorter is not seen."
    }

    test("the skipped rules are known, with the signals that most of them lack") {
        val match = TestMatch().apply { without(BATTERY) }
        val found = RuleSet.BUILT_IN.over(match.view(), "test.bag")
        val unseen = NotLookedAt(found.ran, found.skipped)
        unseen.ran + unseen.skippedCount shouldBe RuleSet.BUILT_IN.rules.size
        unseen.lacking.first() shouldBe "battery"
        unseen.text shouldStartWith "${unseen.ran} rules ran; ${unseen.skippedCount} could not: this log has no “battery”"
        NotLookedAt(3, emptyList()).text shouldBe "3 rules ran."
        listed(listOf("a", "b", "c", "d", "e", "f", "g")) shouldContain "and 2 other signals"
    }
})
