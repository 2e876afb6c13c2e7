package badlog.protocol

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll

private fun crcOf(vararg pieces: ByteArray): Int = Crc32().apply { for (piece in pieces) update(piece) }.value

class Crc32Spec : FunSpec({
    test("the checksum of “123456789” is the check value of CRC-32") {
        crcOf("123456789".encodeToByteArray()) shouldBe 0xCBF43926.toInt()
        crcOf() shouldBe 0
    }

    test("bytes have the same checksum in any pieces") {
        checkAll(Arb.byteArray(Arb.int(0, 100), Arb.byte()), Arb.int(0, 100)) { bytes, cut ->
            val at = cut.coerceAtMost(bytes.size)
            crcOf(bytes.copyOf(at), bytes.copyOfRange(at, bytes.size)) shouldBe crcOf(bytes)
            Crc32().apply { update(bytes, at) }.value shouldBe crcOf(bytes.copyOfRange(at, bytes.size))
        }
    }

    test("one changed bit changes it") {
        checkAll(Arb.byteArray(Arb.int(1, 100), Arb.byte()), Arb.int(0, 799)) { bytes, bit ->
            val at = bit / 8 % bytes.size
            val changed = bytes.copyOf().also { it[at] = (it[at].toInt() xor (1 shl bit % 8)).toByte() }
            (crcOf(changed) == crcOf(bytes)) shouldBe false
        }
    }

    test("after a reset, the checksum starts again") {
        val crc = Crc32().apply { update(byteArrayOf(1, 2, 3)) }
        crc.reset()
        crc.value shouldBe 0
        crc.update(byteArrayOf(9))
        crc.value shouldBe crcOf(byteArrayOf(9))
    }
})
