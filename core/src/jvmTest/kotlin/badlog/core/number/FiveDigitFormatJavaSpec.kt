package badlog.core.number

import io.kotest.assertions.fail
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.long
import io.kotest.property.checkAll
import java.lang.management.ManagementFactory
import java.util.Locale
import kotlin.math.nextDown
import kotlin.math.nextUp
import kotlin.math.pow
import kotlin.math.round
import kotlin.math.sin
import kotlin.random.Random

private val IF_REFERENCE = Runtime.version().feature().let { version ->
    if (version == 17) Enabled.enabled else Enabled.disabled("Java $version does not format like the reference, Java 17")
}

@Tags("InCheck")
class FiveDigitFormatJavaSpec : FunSpec({
    test("equals Java for random bit patterns").config(enabledOrReasonIf = { IF_REFERENCE }) {
        checkAll(200 * PropertyTesting.defaultIterationCount, Arb.long()) { expectJava(Double.fromBits(it)) }
    }

    test("equals Java for doubles of every kind").config(enabledOrReasonIf = { IF_REFERENCE }) {
        checkAll(50 * PropertyTesting.defaultIterationCount, Arb.double()) { expectJava(it) }
    }

    test("equals Java for every binary exponent with random and with extreme fractions").config(enabledOrReasonIf = { IF_REFERENCE }) {
        val random = Random(1)
        for (exponent in 0..2046L) {
            val base = exponent shl 52
            repeat(30) {
                val fraction = random.nextLong() ushr 12
                val zeros = random.nextInt(52)
                expectJava(Double.fromBits(base or fraction))
                expectJava(Double.fromBits(base or (fraction shr zeros shl zeros)))
                expectJava(Double.fromBits(base or (fraction shr zeros)))
                expectJava(-Double.fromBits(base or (fraction shr zeros xor FRACTION)))
            }
            for (bit in 0..51) expectJava(Double.fromBits(base or (1L shl bit)))
            for (edge in 0..3L) {
                expectJava(Double.fromBits(base or edge))
                expectJava(Double.fromBits(base or (FRACTION - edge)))
            }
        }
    }

    test("equals Java for all subnormals of up to 20 bits, and some beyond").config(enabledOrReasonIf = { IF_REFERENCE }) {
        for (units in 0..(1L shl 20) + 20_000) expectJava(Double.fromBits(units))
    }

    test("equals Java for random subnormals").config(enabledOrReasonIf = { IF_REFERENCE }) {
        val random = Random(2)
        repeat(200 * PropertyTesting.defaultIterationCount) { expectJava(Double.fromBits(random.nextLong() ushr 12 + random.nextInt(33))) }
    }

    test("equals Java at and next to decimal ties of every magnitude").config(enabledOrReasonIf = { IF_REFERENCE }) {
        val random = Random(3)
        for (power in -329..303) {
            for (i in 0..39) {
                val digits = when (i) {
                    0 -> 100_005
                    1 -> 999_995
                    else -> random.nextInt(10_000, 100_000) * 10 + 5
                }
                expectJavaAround("${digits}e$power".toDouble(), 3)
            }
        }
    }

    test("equals Java next to all ties of four decimals from 1 to 10 and from 0.1 to 1").config(enabledOrReasonIf = { IF_REFERENCE }) {
        for (digits in 100_005..999_995 step 10) {
            expectJavaAround(digits / 1.0e5, 1)
            expectJava(-digits / 1.0e6)
        }
    }

    test("equals Java for doubles that lie half an ulp from a tie").config(enabledOrReasonIf = { IF_REFERENCE }) {
        for (digits in 295_145..590_305 step 10) expectJavaAround("${digits}e15".toDouble(), 1)
        for (digits in 100_005..118_105 step 10) expectJavaAround("${digits}e16".toDouble(), 1)
    }

    test("equals Java for the doubles that come closest to a tie from half of the distance to the next double").config(enabledOrReasonIf = { IF_REFERENCE }) {
        val closest = listOf(3.77845e-250, 6.2745e51, 1.7854999999999999e266, 8.927499999999999e265, 4.08305e157)
        for (value in closest) expectJavaAround(value, 3)
    }

    test("equals Java for integers and simple fractions").config(enabledOrReasonIf = { IF_REFERENCE }) {
        for (n in -60_000..160_000) {
            expectJava(n.toDouble())
            expectJava(n / 8.0)
            expectJava(n / 1000.0)
        }
    }

    test("equals Java for large integers").config(enabledOrReasonIf = { IF_REFERENCE }) {
        val random = Random(4)
        repeat(100 * PropertyTesting.defaultIterationCount) { expectJava((random.nextLong() ushr random.nextInt(47)).toDouble()) }
    }

    test("equals Java for powers of two and ten and their neighbors").config(enabledOrReasonIf = { IF_REFERENCE }) {
        for (exponent in -1074..1023) expectJavaAround(2.0.pow(exponent), 4)
        for (exponent in -323..308) {
            expectJavaAround("1e$exponent".toDouble(), 4)
            expectJavaAround("99999e${exponent - 5}".toDouble(), 4)
        }
    }

    test("equals Java for a robot's usual values").config(enabledOrReasonIf = { IF_REFERENCE }) {
        val random = Random(5)
        repeat(100 * PropertyTesting.defaultIterationCount) {
            val volts = random.nextDouble(-13.0, 13.0)
            expectJava(volts)
            expectJava(volts.toFloat().toDouble())
            expectJava(round(volts * 1000) / 1000)
            expectJava(sin(it * 0.02) * 1.0e-3)
            expectJava(it * 0.02)
            expectJava(random.nextInt() * 360.0 / 4096)
            expectJava(10.0.pow(random.nextDouble(-9.0, 9.0)))
        }
    }

    test("equals Java for NaN, infinities and zeros").config(enabledOrReasonIf = { IF_REFERENCE }) {
        val values = listOf(
            0.0,
            -0.0,
            Double.NaN,
            Double.fromBits(0x7FF0_0000_0000_0001),
            Double.fromBits(-1),
            Double.POSITIVE_INFINITY,
            Double.NEGATIVE_INFINITY,
            Double.MAX_VALUE,
            -Double.MAX_VALUE,
            Double.MIN_VALUE,
            -Double.MIN_VALUE,
        )
        for (value in values) expectJava(value)
    }

    test("writing a number allocates nothing").config(enabledOrReasonIf = { IF_REFERENCE }) {
        val random = Random(6)
        val values = DoubleArray(4096) {
            when (it % 4) {
                0 -> random.nextDouble(-1000.0, 1000.0)
                1 -> Double.fromBits(random.nextLong())
                2 -> Double.fromBits(random.nextLong() ushr 12 + random.nextInt(52))
                else -> (random.nextInt(100_000) * 10 + 5) / 1.0e4
            }
        }
        // The JVM itself may allocate on this thread at any time, when it compiles. The formatting itself would allocate each time.
        List(10) { allocatedByWriting(values, 50_000) }.min() shouldBe 0
    }
})

private const val FRACTION = (1L shl 52) - 1

private val buffer = ByteArray(FiveDigitFormat.MAX_LENGTH)

private fun expectJava(value: Double) {
    val expected = String.format(Locale.ROOT, "%.5g", value)
    val actual = String(buffer, 0, FiveDigitFormat.write(value, buffer, 0), Charsets.ISO_8859_1)
    if (actual != expected) fail("$value (${value.toRawBits()}) gives $actual, in Java $expected")
}

private fun expectJavaAround(value: Double, steps: Int) {
    expectJava(value)
    var below = value
    var above = value
    repeat(steps) {
        below = below.nextDown()
        above = above.nextUp()
        expectJava(below)
        expectJava(above)
    }
}

private fun allocatedByWriting(values: DoubleArray, calls: Int): Long {
    val threads = ManagementFactory.getThreadMXBean() as com.sun.management.ThreadMXBean
    val before = threads.currentThreadAllocatedBytes
    for (call in 0 until calls) FiveDigitFormat.write(values[call % values.size], buffer, 0)
    return threads.currentThreadAllocatedBytes - before
}
