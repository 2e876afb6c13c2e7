package badlog.cli.text

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.stringPattern
import io.kotest.property.checkAll

class TextSpec : FunSpec({
    test("a text is broken between words, and a word only where a line is too short for it") {
        wrapped("- ", "one two three", width = 9) shouldBe "- one two\n  three"
        wrapped("- ", "a bcdefghij k", width = 6) shouldBe "- a bc\n  defg\n  hij\n  k"
    }

    test("no line exceeds its maximum width, and no word is lost") {
        checkAll(Arb.list(Arb.stringPattern("[a-z]{0,30}"), 0..20), Arb.int(8, 40)) { words, width ->
            val lines = wrapped("first", words.joinToString(" "), width = width).lines()
            lines.filter { it.length > width }.shouldBeEmpty()
            lines.joinToString("").filter { it != ' ' } shouldBe "first" + words.joinToString("")
        }
    }

    test("numbers have the digits that count") {
        listOf(0.0, -0.5, 12.0, 1234567.0, 1.0 / 3, 1e-9, 2e12, Double.NaN).map { shortNumber(it) } shouldBe
            listOf("0", "-0.5", "12", "1234570", "0.333333", "1e-9", "2e+12", "")
        grouped(1234567) shouldBe "1,234,567"
        sizeText(356_616_059) shouldBe "356.6 MB"
    }

    test("times are reported as on a clock") {
        listOf(0.04, 92.0, 155.99, 3599.96, 20031.0).map(XTime::clock) shouldBe listOf("0:00.0", "1:32.0", "2:36.0", "1:00:00", "5:33:51")
    }
})
