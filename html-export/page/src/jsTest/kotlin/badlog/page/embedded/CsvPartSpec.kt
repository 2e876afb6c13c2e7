package badlog.page.embedded

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class CsvPartSpec : FunSpec({
    fun csvOf(file: String, chunkSize: Int): String {
        val part = CsvPart(hasHeaderLine = true)
        return file.encodeToByteArray().toList().chunked(chunkSize)
            .flatMap { part.filter(it.toByteArray()).toList() }.toByteArray().decodeToString()
    }

    test("the header line is removed with any line end, wherever the chunks are cut") {
        for (lineEnd in listOf("\n", "\r\n", "\r")) {
            for (chunkSize in 1..20) {
                csvOf("{\"topics\":[]}${lineEnd}a,b${lineEnd}1,2$lineEnd", chunkSize) shouldBe
                    "a,b${lineEnd}1,2$lineEnd"
            }
        }
    }

    test("blank lines before the header are removed with it") {
        csvOf("\n\n{}\na\n", 100) shouldBe "a\n"
    }

    test("plain CSV stays unchanged") {
        CsvPart(hasHeaderLine = false).filter("a\n1\n".encodeToByteArray()).decodeToString() shouldBe "a\n1\n"
    }
})
