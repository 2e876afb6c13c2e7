package badlog.files

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.PropertyTesting
import java.nio.channels.FileChannel
import java.nio.file.Files
import kotlin.random.Random

class LineCountSpec : FunSpec({
    test("line feeds counted eight bytes at a time are as many as one by one, whatever bytes are beside them") {
        val random = Random(2468)
        repeat(5 * PropertyTesting.defaultIterationCount) {
            val near = byteArrayOf(9, 10, 11, 0, 0x0a, 0x8a.toByte(), -1, 0x7f)
            val bytes = ByteArray(random.nextInt(40)) { near[random.nextInt(near.size)] }
            lineFeedsIn(bytes, bytes.size) shouldBe bytes.count { it == '\n'.code.toByte() }
        }
    }

    test("all cores together count a file's lines once") {
        inFolder { folder ->
            for (size in listOf(0, 1, 5, (1 shl 18) + 3, 2_000_003)) {
                val random = Random(size)
                val bytes = ByteArray(size) { if (random.nextInt(30) == 0) 10 else 65 }
                val file = Files.write(folder.resolve("$size.csv"), bytes)
                val lines = bytes.count { it == '\n'.code.toByte() }.toLong()
                for (cores in 1..3) FileChannel.open(file).use { countLines(it, size.toLong(), cores) } shouldBe lines
            }
        }
    }
})
