package badlog.rules

import badlog.signals.LogShape
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.matchers.string.shouldStartWith

private const val FPGA = "/SystemStats/FPGAVersion"

/** A match with a fault of power, one of a motor and one of the program. */
private fun matchWith(own: TestMatch.() -> Unit) = TestMatch().apply {
    from(20.0, "Drive/Left/TempCelsius") { (80 + (it - 20)).toString() }
    number("/PowerDistribution/Faults") { if (it < 20) 0.0 else 4.0 }
    event("messages", 20.0 to "Unhandled exception: java.lang.NullPointerException")
    own()
}

private fun LogFindings.rules() = findings.map { it.rule }

class SimulationSpec : FunSpec({
    fun found(own: TestMatch.() -> Unit) = RuleSet.BUILT_IN.over(matchWith(own).view(), "test.bag")

    fun LogFindings.isSimulation() = NotLookedAt(ran, skipped).simulated != null

    test("a robot's faults are found") {
        found {}.run {
            isSimulation() shouldBe false
            rules() shouldBe listOf("Breaker open", "Motor too hot", "Error logged", "Code crashed").filter { it in rules() }
            rules().size shouldBe 4
        }
    }

    test("over a simulation, only rules about the program's messages and the drivers' inputs run") {
        found { number(BATTERY) { 12.0 } }.run {
            rules() shouldBe listOf("Error logged", "Code crashed")
            val text = NotLookedAt(ran, skipped).text
            text shouldStartWith "A simulation (its battery had exactly 12 V throughout): rules about power, wear and sensors do not run. "
            text shouldNotContain "could not"
            skipped.first { it.rule == "Breaker open" }.message shouldContain "the robot was simulated"
        }
    }

    test("a battery that WPILib calculates from the current rests at exactly 12 V") {
        found { number(BATTERY) { 12.0 - 0.0187 * (TestMatch.load(it) - TestMatch.load(0.0)).coerceAtLeast(0.0) } }.isSimulation() shouldBe true
    }

    test("a power distribution that was never written is of a simulation if its voltage is 12 V or none") {
        fun isSimulation(volts: Double, amperes: Double) = found {
            number(BATTERY) { if (it.toInt() % 7 == 0) volts else 0.0 }
            number("/PowerDistribution/ChannelCurrent[0]") { amperes }
        }.isSimulation()
        isSimulation(12.0, 6.95e-310) shouldBe true
        isSimulation(12.1, 6.95e-310) shouldBe false
        isSimulation(12.0, 5.0) shouldBe false
    }

    test("a weak battery with rounded values is a real one") {
        found { number(BATTERY) { Math.round(120 - 0.2 * TestMatch.load(it)) / 10.0 } }.isSimulation() shouldBe false
    }

    test("the FPGA of the simulation is recognized") {
        found { number(FPGA) { 2018.0 } }.isSimulation() shouldBe true
        found { number(FPGA) { 0x2024.toDouble() } }.isSimulation() shouldBe false
    }

    test("metadata that names a simulation counts, and a similar name does not") {
        for ((text, isSimulated) in listOf("kSimulation" to true, "SIM" to true, "SIMBOT" to true, "kRoboRIO" to false, "Simple drive" to false)) {
            found { state("/RealMetadata/RuntimeType", text) }.isSimulation() shouldBe isSimulated
        }
        found { state("Arm/Simulation", "SIM") }.isSimulation() shouldBe false
        // A replay of a real match.
        found { state("/ReplayMetadata/RuntimeType", "kSimulation") }.isSimulation() shouldBe false
    }

    test("a robot with all dashboards on its own computer is simulated") {
        fun client(address: String) = "\"{\"\"connected\"\":true,\"\"remote_ip\"\":\"\"$address\"\",\"\"remote_port\"\":5}\""
        found { event("NTConnection", 3.0 to client("127.0.0.1")) }.isSimulation() shouldBe true
        found { event("NTConnection", 3.0 to client("127.0.0.1"), 5.0 to client("10.10.14.5")) }.isSimulation() shouldBe false
    }

    test("the topics that show a simulation are among the ones that rules read") {
        val view = TestMatch().apply { number(FPGA) { 2018.0 } }.view()
        (FPGA in RuleProgram(RuleSet.BUILT_IN, LogShape.of(view)).topics) shouldBe true
    }

    test("a team's own rules run over simulations, too") {
        val own = RulesFile.parse("[[rule]]\nname = \"Own\"\nseverity = \"note\"\nwhen = \"min(battery) < 13\"\ntext = \"Low.\"\n").rules
        TestMatch().apply { number(BATTERY) { 12.0 } }.findings(own).map { it.rule } shouldBe listOf("Own")
    }

    test("rules keep in JSON whether they run over simulations") {
        val read = checkNotNull(RuleSet.fromJson(RuleSet.BUILT_IN.toJson()))
        read.rules.filter { it.isForSimulations != RuleSet.BUILT_IN.rules.first { own -> own.name == it.name }.isForSimulations }.shouldBeEmpty()
    }
})
