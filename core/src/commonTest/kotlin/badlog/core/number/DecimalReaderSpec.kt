package badlog.core.number

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.filter
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.long
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll

private fun read(text: String): Double? {
    val bytes = "<$text>".encodeToByteArray()
    val reader = DecimalReader()
    return if (reader.read(bytes, 1, bytes.size - 1)) reader.value else null
}

class DecimalReaderSpec : FunSpec({
    test("numbers are read as the platform reads them") {
        for (text in listOf("0", "-0", "+5", "1.", ".5", "007.50", "1e5", "1E+05", "1.2346e-05", "123456789012345678")) {
            read(text) shouldBe text.toDouble()
        }
    }

    test("text that is not exactly a number is not read as one") {
        for (text in listOf("", "-", ".", "1.2.3", "1e", "1e+", "e5", "1 2", "0x10", "1f", "--1", "1,5", "½")) {
            read(text) shouldBe null
        }
    }

    test("any double written in full is read back exactly") {
        checkAll(Arb.long().map { Double.fromBits(it) }.filter { it.isFinite() }) { number ->
            read(number.toString()) shouldBe number
        }
    }

    test("decimals of any length and exponent are rounded like the platform's") {
        checkAll(Arb.long(), Arb.int(-60..60)) { digits, exponent ->
            val text = "${digits}e$exponent"
            read(text) shouldBe text.toDouble()
            val shorter = "${digits % 100_000_000_000_000_000L}e$exponent"
            read(shorter) shouldBe shorter.toDouble()
        }
    }

    test("halfway cases are rounded like the platform's") {
        for (text in listOf(
            "9007199254740993", "9007199254740992.5", "900719925474099.25", "1.00000000000000011102230246251565",
            "0.500000000000000055", "2.2250738585072011e-308", "4.9e-324", "1e400", "-1e-400", "8.5e17",
        )) {
            read(text) shouldBe text.toDouble()
        }
    }
})
