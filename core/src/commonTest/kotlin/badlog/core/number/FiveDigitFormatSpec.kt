package badlog.core.number

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe

class FiveDigitFormatSpec : FunSpec({
    test("texts equal those of Java 17") {
        val wrong = javaTexts.filter { (value, text) -> textOf(value) != text }
        wrong.map { (value, text) -> "$value gives ${textOf(value)}, in Java $text" }.shouldBeEmpty()
    }

    test("the longest text has the greatest length") {
        javaTexts.maxOf { (_, text) -> text.length } shouldBe FiveDigitFormat.MAX_LENGTH
    }

    test("bytes outside the returned range keep their values") {
        for ((value, text) in javaTexts) {
            val bytes = ByteArray(5 + text.length + 5) { 0x55 }
            val end = FiveDigitFormat.write(value, bytes, 5)
            end shouldBe 5 + text.length
            bytes.decodeToString() shouldBe "UUUUU${text}UUUUU"
        }
    }

    test("a text that just fits is written") {
        for ((value, text) in javaTexts) {
            val bytes = ByteArray(2 + text.length)
            FiveDigitFormat.write(value, bytes, 2) shouldBe bytes.size
        }
    }

    test("a text that does not fit throws and leaves the bytes unchanged") {
        for ((value, text) in javaTexts) {
            val bytes = ByteArray(2 + text.length - 1) { 0x55 }
            shouldThrow<IndexOutOfBoundsException> { FiveDigitFormat.write(value, bytes, 2) }
            bytes.all { it == 0x55.toByte() } shouldBe true
        }
    }

    test("an index outside the bytes throws") {
        val bytes = ByteArray(FiveDigitFormat.MAX_LENGTH) { 0x55 }
        for (at in listOf(-1, Int.MIN_VALUE, bytes.size, bytes.size + 1, Int.MAX_VALUE)) {
            for (value in listOf(1.0, 0.0, 1.0e100)) {
                shouldThrow<IndexOutOfBoundsException> { FiveDigitFormat.write(value, bytes, at) }
            }
        }
        bytes.all { it == 0x55.toByte() } shouldBe true
    }
})

private fun textOf(value: Double): String {
    val bytes = ByteArray(FiveDigitFormat.MAX_LENGTH)
    return bytes.decodeToString(0, FiveDigitFormat.write(value, bytes, 0))
}

/** Values and what `String.format(Locale.ROOT, "%.5g", value)` of Java 17 gives for them. */
private val javaTexts = listOf(
    0.0 to "0.0000",
    -0.0 to "-0.0000",
    1.0 to "1.0000",
    -1.0 to "-1.0000",
    10.0 to "10.000",
    100.0 to "100.00",
    1000.0 to "1000.0",
    10000.0 to "10000",
    99999.0 to "99999",
    100000.0 to "1.0000e+05",
    12.3456 to "12.346",
    -12.3456 to "-12.346",
    3.141592653589793 to "3.1416",
    0.1 to "0.10000",
    0.2 to "0.20000",
    0.30000000000000004 to "0.30000",
    0.02 to "0.020000",
    0.01 to "0.010000",
    0.001 to "0.0010000",
    1.0e-4 to "0.00010000",
    9.9999e-5 to "9.9999e-05",
    9.99994e-5 to "9.9999e-05",
    9.99995e-5 to "0.00010000",
    1.0e-5 to "1.0000e-05",
    -1.0e-5 to "-1.0000e-05",
    1.2345678e-7 to "1.2346e-07",
    6.123233995736766e-17 to "6.1232e-17",
    123456.0 to "1.2346e+05",
    -123456.0 to "-1.2346e+05",
    99999.4 to "99999",
    99999.5 to "1.0000e+05",
    99999.49999999999 to "99999",
    9999.95 to "10000",
    9999.949999999999 to "9999.9",
    999999.5 to "1.0000e+06",
    0.99999 to "0.99999",
    0.999995 to "1.0000",
    0.9999949999999999 to "0.99999",
    2.00005 to "2.0001",
    1.00005 to "1.0001",
    1.00015 to "1.0002",
    1.55565 to "1.5557",
    1.5556499999999998 to "1.5556",
    0.5 to "0.50000",
    0.03125 to "0.031250",
    12.34375 to "12.344",
    12.34385 to "12.344",
    4096.125 to "4096.1",
    4096.25 to "4096.3",
    2047.75 to "2047.8",
    65535.0 to "65535",
    65536.0 to "65536",
    2.147483647e9 to "2.1475e+09",
    1.6777216e7 to "1.6777e+07",
    9.007199254740991e15 to "9.0072e+15",
    9.2233720368547748e18 to "9.2234e+18",
    9.223372036854776e18 to "9.2234e+18",
    4.7073499999999997e20 to "4.7073e+20",
    4.7073500000000003e20 to "4.7074e+20",
    3.2402499999999997e20 to "3.2402e+20",
    2.9514749999999998e20 to "2.9515e+20",
    2.9514790517935283e20 to "2.9515e+20",
    1.0000499999999999e21 to "1.0000e+21",
    1.0390499999999999e21 to "1.0390e+21",
    1.1805500000000001e21 to "1.1806e+21",
    1.0e22 to "1.0000e+22",
    9.999999999999999e22 to "1.0000e+23",
    0.002 to "0.0020000",
    2.2250738585072014e-308 to "2.2251e-308",
    2.225073858507201e-308 to "2.2251e-308",
    1.7976931348623157e308 to "1.7977e+308",
    -1.7976931348623157e308 to "-1.7977e+308",
    4.9e-324 to "4.9000e-324",
    -4.9e-324 to "-4.9000e-324",
    1.0e-323 to "1.0000e-323",
    1.5e-323 to "1.5000e-323",
    2.0e-323 to "2.0000e-323",
    1.0e-322 to "1.0000e-322",
    1.04e-322 to "1.0400e-322",
    1.0e-321 to "1.0000e-321",
    1.0e-320 to "1.0000e-320",
    4.94e-321 to "4.9400e-321",
    2.024e-320 to "2.0240e-320",
    1.0e-319 to "1.0000e-319",
    5.180654e-318 to "5.1807e-318",
    5.18065e-318 to "5.1807e-318",
    1.295163e-318 to "1.2952e-318",
    1.0e-310 to "1.0000e-310",
    9.99995e-300 to "1.0000e-299",
    3.77845e-250 to "3.7785e-250",
    6.2745e51 to "6.2745e+51",
    1.7854999999999999e266 to "1.7855e+266",
    1.7855e266 to "1.7855e+266",
    4.0830499999999997e157 to "4.0830e+157",
    2.5e-100 to "2.5000e-100",
    9.9999499e99 to "9.9999e+99",
    9.99995e99 to "1.0000e+100",
    9.99995e-100 to "1.0000e-99",
    1.0e100 to "1.0000e+100",
    1.0e-99 to "1.0000e-99",
    Double.NaN to "NaN",
    Double.POSITIVE_INFINITY to "Infinity",
    Double.NEGATIVE_INFINITY to "-Infinity",
)
