package badlog.viewer.shown.battery

import badlog.signals.battery.BatteryUse
import badlog.signals.battery.Resistance
import badlog.signals.battery.TeamBattery
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe

class BatteryAdviceSpec : FunSpec({
    fun adviceOn(vararg uses: BatteryUse, team: List<TeamBattery> = emptyList()) = BatteryAdvice.of(BatterySeason.of(uses.mapIndexed { i, use -> batteryLog(i + 1, use) }, team))

    fun use(name: String?, milliohms: Double? = null, rest: Double? = null) = BatteryUse(name, restBefore = rest, resistance = milliohms?.let { Resistance(it, 0.3) })

    test("the next battery is the longest rested of those as good as the best") {
        val advice = adviceOn(use("A1", 20.0), use("B2", 20.2), use("C3", 23.0), use("A1", 20.0), use("B2", 20.2), use("C3", 23.0))
        advice.next?.name shouldBe "A1"
        advice.next?.reason shouldBe "Its resistance is 20.0 ± 0.2 mΩ and it has rested since Qualification 4."
        advice.next?.headline shouldBe "Use A1 next"
        advice.inPit.map { it.pitText } shouldContainExactly listOf("Battery: use A1 next")
        advice.retire.shouldBeEmpty()
    }

    test("the battery of the last match is not the next one if there is another") {
        adviceOn(use("A1", 25.0), use("B2", 20.0)).next?.name shouldBe "A1"
        adviceOn(use("B2", 20.0)).next?.reason shouldBe "Its resistance is 20.0 ± 0.3 mΩ and it is the only usable one."
    }

    test("a battery with certainly a third more resistance than the best is retired, with the reason") {
        val advice = adviceOn(use("A1", 20.0), use("B2", 28.0), use("B2", 28.0), use("C3", 25.0), use("A1", 20.0))
        advice.retire.map { it.name to it.reason } shouldContainExactly
            listOf("B2" to "Its resistance is 28.0 ± 0.2 mΩ, 40 % more than that of A1 (20.0 ± 0.2 mΩ).")
        advice.next?.name shouldBe "C3"
    }

    test("a retired battery is neither next nor retired again") {
        val advice = adviceOn(use("A1", 40.0), use("B2", 20.0), team = listOf(TeamBattery("A1", isRetired = true)))
        advice.next?.name shouldBe "B2"
        advice.retire.shouldBeEmpty()
    }

    test("a battery that was not full before three matches is checked") {
        val advice = adviceOn(use("A1", rest = 12.8), use("B2", rest = 12.1), use("B2", rest = 12.25), use("B2", rest = 12.2))
        advice.charge.single().reason shouldBe
            "Before its last 3 matches it rested at 12.10 V to 12.25 V; a full battery has 12.40 V or more."
        adviceOn(use("B2", rest = 12.1), use("B2", rest = 12.6), use("B2", rest = 12.2)).charge.shouldBeEmpty()
    }

    test("one match is too little to retire a battery, because it does not show how much matches differ") {
        adviceOn(use("A1", 20.0), use("B2", 40.0), use("A1", 20.0)).retire.shouldBeEmpty()
    }

    test("a battery without a log is next if only the last match's battery is left") {
        val advice = adviceOn(use("A1", 20.0), team = listOf(TeamBattery("D4")))
        advice.next?.name shouldBe "D4"
        advice.next?.reason shouldBe "No log has it yet."
        adviceOn(team = listOf(TeamBattery("D4"))).next.shouldBeNull()
    }

    test("a battery to be checked is not the next one if there is another") {
        val advice = adviceOn(use("A1", rest = 12.8), use("B2", rest = 12.1), use("B2", rest = 12.1), use("B2", rest = 12.1), use("C3", rest = 12.8))
        advice.next?.name shouldBe "A1"
    }

    test("a battery's rest is not reported if a later battery is unknown") {
        adviceOn(use("A1"), use("B2"), use(null)).next?.reason shouldBe "Its resistance was not measured and no log after Qualification 1 names it."
    }

    test("each is compared with the best one known, even with the one in the last match") {
        val advice = adviceOn(use("A1", 25.0), use("C3", 21.9), use("B2", 22.0))
        advice.next?.name shouldBe "C3"
        adviceOn(use("A1", 25.0), use("B2", 20.0)).next?.reason shouldBe
            "Its resistance is 25.0 ± 0.3 mΩ (B2: 20.0 ± 0.3 mΩ) and it has rested since Qualification 1."
    }

    test("a battery that browned out in its last match is never the next one, but checked") {
        fun low(name: String, volts: Double) = BatteryUse(name, lowest = volts, resistance = Resistance(20.0, 0.3), isBrownedOut = volts < 6.3)
        val advice = adviceOn(low("B3", 6.21), low("A1", 8.1))
        advice.next?.name shouldBe "A1"
        advice.charge.single().text shouldBe "Check B3. The robot browned out with it in Qualification 1."
        adviceOn(low("B3", 6.21)).next.shouldBeNull()
        adviceOn(low("B3", 6.21), low("A1", 8.1), low("B3", 8.0), low("A1", 8.1)).next?.name shouldBe "B3"
    }

    test("unnamed batteries get no advice") {
        val advice = adviceOn(use(null, 20.0), use(null, 30.0))
        advice.next.shouldBeNull()
        advice.retire.shouldBeEmpty()
    }
})
