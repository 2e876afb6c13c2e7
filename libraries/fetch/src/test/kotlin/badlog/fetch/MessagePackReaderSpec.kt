package badlog.fetch

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import java.nio.ByteBuffer

class MessagePackReaderSpec : FunSpec({
    fun reader(vararg bytes: Int) = MessagePackReader(ByteBuffer.wrap(ByteArray(bytes.size) { bytes[it].toByte() }))

    test("whole numbers of every width are read") {
        val reader = reader(
            0x94, 0x07, 0xCC, 0xFF, 0xCD, 0x12, 0x34, 0xCE, 0xFF, 0, 0, 1,
            0xCF, 0, 0, 0, 1, 0, 0, 0, 0, 0xD0, 0x80, 0xD1, 0xFF, 0xFE, 0xD2, 0xFF, 0xFF, 0xFF, 0xFF, 0xD3, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xF0, 0xFF,
        )
        reader.arraySize() shouldBe 4
        generateSequence { if (reader.hasNext) reader.number() else null }.toList() shouldContainExactly
            listOf(7L, 255L, 0x1234L, 0xFF000001L, 0x1_0000_0000L, -128L, -2L, -1L, -16L, -1L)
    }

    test("a struct of 64 bits is read as a whole number, lowest byte first") {
        val reader = reader(0xC4, 8, 1, 2, 3, 4, 5, 6, 7, 0x24, 0x07, 0xC4, 2, 1, 1)
        reader.word() shouldBe 0x2407060504030201L
        reader.word() shouldBe 7L
        reader.word() shouldBe null
    }

    test("anything else is null") {
        reader(0xCB, 0, 0, 0, 0, 0, 0, 0, 0).number() shouldBe null
        reader(0xA1, 0x61).number() shouldBe null
        reader(0x81, 1, 2).arraySize() shouldBe null
    }
})
