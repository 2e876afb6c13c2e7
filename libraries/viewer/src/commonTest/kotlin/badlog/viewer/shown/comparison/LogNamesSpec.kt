package badlog.viewer.shown.comparison

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class LogNamesSpec : FunSpec({
    fun match(event: String, number: Int, file: String) = LogName(event, "Qualification $number", "$event Qualification $number", file)

    test("matches of one event are distinguished by their numbers alone") {
        namesBeside(listOf(match("Mill Creek", 42, "a.bag"), match("Mill Creek", 57, "b.bag"))) shouldBe
            listOf("Qualification 42", "Qualification 57")
    }

    test("matches of several events keep the event") {
        namesBeside(listOf(match("Mill Creek", 42, "a.bag"), match("Lake", 42, "b.bag"))) shouldBe
            listOf("Mill Creek Qualification 42", "Lake Qualification 42")
    }

    test("equal names are distinguished by their files") {
        namesBeside(listOf(match("Lake", 3, "a.bag"), match("Lake", 3, "b.bag"), LogName(null, null, "bench.csv", "bench.csv"))) shouldBe
            listOf("Qualification 3 (a.bag)", "Qualification 3 (b.bag)", "bench.csv (bench.csv)")
    }

    test("files of one name are distinguished by as many folders as necessary") {
        fun names(vararg paths: String) = namesBeside(paths.map { match("Lake", 3, it) }).map { it.substringAfter('(').removeSuffix(")") }
        names("2026/lake/friday/q3.bag", "2026/lake/saturday/q3.bag") shouldBe listOf("friday/q3.bag", "saturday/q3.bag")
        names("2026/lake/q3.bag", "2026/lake/q3-2.bag") shouldBe listOf("q3.bag", "q3-2.bag")
        names("q3.bag", "lake/q3.bag") shouldBe listOf("q3.bag", "lake/q3.bag")
        names("lake/q3.bag", "lake/q3.bag") shouldBe listOf("lake/q3.bag", "lake/q3.bag")
    }

    test("a long name keeps its end, which distinguishes matches") {
        shortLabel("Mill Creek Regional Qualification 42", 15) shouldBe "Mill Cr…tion 42"
        shortLabel("Qualification 4", 15) shouldBe "Qualification 4"
    }
})
