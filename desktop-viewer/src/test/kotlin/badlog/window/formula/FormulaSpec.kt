package badlog.window.formula

import androidx.compose.ui.text.AnnotatedString
import badlog.expression.ExpressionError
import badlog.expression.VirtualTopic
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.defaultBoard
import badlog.window.bagOf
import badlog.window.graph.withFormulas
import badlog.window.layout.fitted
import badlog.window.recordingOf
import badlog.window.sidebar.acrossLog
import badlog.window.theme.Palette
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.types.shouldBeInstanceOf

class FormulaSpec : FunSpec({
    val power = "Power [W] = Battery Voltage * Total Current"
    val recording = recordingOf(
        bagOf(listOf("Time|xaxis", "System/Battery Voltage", "PDP/Total Current"), listOf("0,12,1", "1,11,2", "2,10,3")),
    )

    test("a formula is a topic of its folder, with a unit, samples, and brackets around its title") {
        val open = recording.withFormulas(listOf("Drive/$power", "Twice = 2 * Drive/Power"))
        val signal = open.signal("Drive/Power").shouldNotBeNull()
        signal.title shouldBe "[ Power ]"
        signal.unit shouldBe "W"
        signal.folder shouldBe "Drive"
        signal.definition shouldBe "Drive/$power"
        signal.series.y.toList() shouldContainExactly listOf(12.0, 22.0, 30.0)
        open.signal("Twice").shouldNotBeNull().series.y.toList() shouldContainExactly listOf(24.0, 44.0, 60.0)
        defaultBoard(open.logged) shouldBe defaultBoard(recording.view)
    }

    test("a formula has statistics; over a log without samples, it is reported as empty") {
        val open = recording.withFormulas(listOf(power))
        acrossLog(open, listOf("Power"), "").statistics.getValue("Power").mean shouldBe (17.0 plusOrMinus 1e-9)
        val nothing = recordingOf("").withFormulas(listOf("One = 1"))
        reasonFor(nothing.formulas.single(), nothing) shouldBe "It has no samples here."
        nothing.signals shouldBe emptyList()
    }

    test("a formula that fails in a recording gives a reason, and does not affect the others") {
        val definitions = listOf("A = Arm/Angle + 1", power, "Nothing", "B = Power / 2")
        val open = recording.withFormulas(definitions)
        open.formulas.map { it.definition } shouldContainExactly definitions
        open.formulas.map { it.topic != null } shouldContainExactly listOf(false, true, false, true)
        reasonFor(open.formulas[0], open).shouldNotBeNull() shouldContain "Arm/Angle"
        reasonFor(open.formulas[1], open) shouldBe null
        open.signal("B").shouldNotBeNull().series.y.last() shouldBe 15.0
        // A layout that draws the formula still lacks nothing.
        fitted(Board().withGraph(listOf("A", "Power")), open).missing shouldBe emptyList()
        fitted(Board().withGraph(listOf("C", "Power")), open).missing shouldBe listOf("C")
    }

    test("the place of a mistake is underlined; if something is missing, the text before it") {
        val vocabulary = vocabularyFor(recording, null)
        fun underlined(text: String): String {
            val error = VirtualTopic.parse(text, vocabulary).shouldBeInstanceOf<ExpressionError>()
            return underlined(AnnotatedString(text), error, Palette.LIGHT).spanStyles.single().let { text.substring(it.start, it.end) }
        }
        underlined("P = Batery Voltage * 2") shouldBe "Batery Voltage"
        underlined("P = 2 *") shouldBe "*"
    }

    test("a formula may be changed without conflicting with itself") {
        val open = recording.withFormulas(listOf(power, "B = Power / 2"))
        VirtualTopic.parse(power, vocabularyFor(open, power)).shouldBeInstanceOf<VirtualTopic>()
        VirtualTopic.parse(power, vocabularyFor(open, null)).shouldBeInstanceOf<ExpressionError>()
        VirtualTopic.parse("C = B * 2", vocabularyFor(open, power)).shouldBeInstanceOf<ExpressionError>()
    }
})
