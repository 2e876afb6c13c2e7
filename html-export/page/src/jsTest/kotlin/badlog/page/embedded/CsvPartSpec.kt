package badlog.page.embedded

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class CsvPartSpec : FunSpec({
    fun csvOf(file: String, chunkSize: Int): String {
        val part = CsvPart(hasHeaderLine = true)
        return file.encodeToByteArray().toList().chunked(chunkSize)
            .flatMap { part.filter(it.toByteArray()).toList() }.toByteArray().decodeToString()
    }

    test("the first line is left out, whatever ends it and wherever it is cut") {
        for (lineEnd in listOf("\n", "\r\n", "\r")) {
            for (chunkSize in 1..20) {
                csvOf("{\"topics\":[]}${lineEnd}a,b${lineEnd}1,2$lineEnd", chunkSize) shouldBe
                    "a,b${lineEnd}1,2$lineEnd"
            }
        }
    }

    test("blank lines before it go with it") {
        csvOf("\n\n{}\na\n", 100) shouldBe "a\n"
    }

    test("plain CSV stays as it is") {
        CsvPart(hasHeaderLine = false).filter("a\n1\n".encodeToByteArray()).decodeToString() shouldBe "a\n1\n"
    }
})
