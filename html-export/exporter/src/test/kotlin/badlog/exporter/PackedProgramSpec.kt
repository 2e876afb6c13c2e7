package badlog.exporter

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldNotContainAnyOf
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import kotlin.random.Random

internal class PackedProgramSpec : FunSpec({
    test("any bytes come back from the digits that stand for them") {
        checkAll(Arb.byteArray(Arb.int(0..300), Arb.byte())) { bytes ->
            ofBase122(base122(bytes).decodeToString()).toList() shouldBe bytes.toList()
        }
    }

    test("bytes of which every bit is the same come back, however many they are") {
        for (size in 0..200) {
            for (value in listOf(0, -1)) {
                val bytes = ByteArray(size) { value.toByte() }
                ofBase122(base122(bytes).decodeToString()).toList() shouldBe bytes.toList()
            }
        }
    }

    test("digits are ASCII, and none is a character that HTML, a terminal or an old file system changes or ends at") {
        val text = base122(Random(1).nextBytes(1 shl 16))
        text.toSet().shouldNotContainAnyOf(listOf(0x00, 0x0c, 0x0d, 0x1a, 0x1b, '<'.code).map(Int::toByte))
        text.all { it > 0 } shouldBe true
        text.toSet().size shouldBe 122
        text.size.toDouble() / (1 shl 16) shouldBeLessThan 1.16
    }

    test("a packed text comes back") {
        unpacked(packed("a{}\u0000let ü = '</script>'").decodeToString()) shouldBe "a{}\u0000let ü = '</script>'"
    }
})
