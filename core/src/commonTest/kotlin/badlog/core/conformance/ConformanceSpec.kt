package badlog.core.conformance

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe

class ConformanceSpec : FunSpec({
    val names = corpusFileNames().filter { it.endsWith(".bag") }.map { it.removeSuffix(".bag") }

    test("the corpus has files") {
        names.size shouldBeGreaterThan 45
    }

    for (name in names) {
        val bytes = readCorpusFile("$name.bag")
        val expected = comparable(readCorpusFile("$name.json").decodeToString())

        test("$name, whole") { jsonReadFrom(bytes, bytes.size) shouldBe expected }
        test("$name, byte by byte") { jsonReadFrom(bytes, 1) shouldBe expected }
        test("$name, in pieces of 7") { jsonReadFrom(bytes, 7) shouldBe expected }
    }
})
