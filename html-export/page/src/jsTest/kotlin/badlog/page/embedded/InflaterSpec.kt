package badlog.page.embedded

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import org.khronos.webgl.Int8Array

class InflaterSpec : FunSpec({
    val zlib: dynamic = js("require('zlib')")

    fun gzip(bytes: ByteArray, level: Int): ByteArray {
        val options = js("({})")
        options.level = level
        val buffer = zlib.gzipSync(bytes, options)
        return Int8Array(buffer.buffer, buffer.byteOffset, buffer.length).unsafeCast<ByteArray>().copyOf()
    }

    fun inflate(compressed: ByteArray): String {
        val text = StringBuilder()
        Inflater(compressed) { text.append(it.decodeToString()) }.run()
        return text.toString()
    }

    val file = buildString { for (i in 0 until 20_000) append(i * 7919 % 10_007).append(if (i % 9 == 0) '\n' else ',') }
    val bytes = file.encodeToByteArray()

    test("stored, fixed and dynamic blocks are inflated") {
        for (level in listOf(0, 1, 6, 9)) inflate(gzip(bytes, level)) shouldBe file
        inflate(gzip("bag".encodeToByteArray(), 9)) shouldBe "bag"
    }

    test("several members are inflated to the end of the last one") {
        inflate(gzip(bytes, 6) + gzip(bytes, 1) + gzip(ByteArray(0), 6)) shouldBe file + file
    }

    test("a cut stream is inflated up to the cut") {
        val whole = gzip(bytes, 6)
        inflate(whole.copyOf(whole.size - 8)) shouldBe file
        val half = inflate(whole.copyOf(whole.size / 2))
        (half.length > file.length / 4) shouldBe true
        file.startsWith(half) shouldBe true
    }

    test("nonsense inflates to nothing, and ends") {
        inflate(ByteArray(1000) { (it * 31).toByte() }) shouldBe ""
        val damaged = gzip(bytes, 6).also { for (i in 5000 until 5100) it[i] = 0x55 }
        file.take(1000) shouldBe inflate(damaged).take(1000)
    }
})
