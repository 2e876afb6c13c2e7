package badlog.architecture.english

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import java.io.File

private fun phrasesIn(name: String, text: String) = placesIn(name, text).map { "${it.line} ${it.text}" }

class PlainEnglishSpec : FunSpec({
    test("each kind of phrase is found in a comment, and named with its line") {
        val comment = """
            /**
             * What a log has, as far as it is known, whose name
             * is that of the file.
             */
            // Nobody reads the half of which nothing is left: it is no log.
        """.trimIndent()
        phrasesIn("A.kt", comment) shouldContainExactly
            listOf("2 What a", "2 as far as", "2 whose", "3 that of", "5 Nobody", "5 of which", "5 is no log")
        placesIn("A.kt", comment).map { it.phrase }.toSet() shouldBe Phrase.entries.toSet()
    }

    test("a phrase is found across the lines of a comment") {
        phrasesIn("A.kt", "/**\n * The files as\n * far as it goes.\n */") shouldContainExactly listOf("2 as far as")
        phrasesIn("A.kt", "// The end\n// of\n") shouldContainExactly emptyList()
    }

    test("plain sentences have no places") {
        phrasesIn("A.kt", "// It is no longer open, if there is no file, whatever it reads. Some body of a file.").shouldBeEmpty()
    }

    test("code, strings and names of parameters are not English") {
        val code = "val whose = \"// what the\" + '\"' // plain\nval raw = \"\"\"\n// what a\n\"\"\"\n/** @param whose `what a` ```\nwhat the\n``` */"
        phrasesIn("A.kt", code).shouldBeEmpty()
        phrasesIn("A.gradle", "url 'https://x/what a' // whose").shouldContainExactly("1 whose")
        phrasesIn("a.md", "Write `what a`.\n\n```\nwhat the\n```\n\nIt shows what the log has.") shouldContainExactly listOf("7 what the")
        phrasesIn("a.txt", "what a").shouldBeEmpty()
    }

    test("comments and documentation of Python are read, and its strings are not") {
        phrasesIn("a.py", "x = '# what a'  # whose\n\"\"\"What the log has.\"\"\"\n") shouldContainExactly listOf("1 whose", "2 What the")
    }

    test("a module with more phrases than accepted is reported, and a new module may not have any") {
        val ratchet = Ratchet(mapOf("core" to 3, "docs" to 1))
        ratchet.exceededBy(mapOf("core" to 3, "docs" to 0)) shouldBe emptyMap()
        ratchet.exceededBy(mapOf("core" to 4, "docs" to 1, "new" to 1)) shouldBe mapOf("core" to 4, "new" to 1)
    }

    test("numbers are lowered and never raised, and follow the modules") {
        Ratchet(mapOf("core" to 3, "docs" to 1, "gone" to 7)).loweredTo(mapOf("core" to 2, "docs" to 5, "new" to 4)).accepted shouldBe
            mapOf("core" to 2, "docs" to 1, "new" to 4)
    }

    test("a ratchet is read as it was written, and a line without a number is refused") {
        val ratchet = Ratchet(mapOf("libraries/season" to 4, "core" to 12))
        Ratchet.of(ratchet.text()).accepted shouldBe ratchet.accepted
        shouldThrow<IllegalStateException> { Ratchet.of("core\n") }.message shouldBe
            "“core” is not a module and a number; correct it, or remove it and run ./gradlew format."
    }

    test("files count for the innermost module, and generated files do not count") {
        val root = tempdir()
        fun write(path: String) = File(root, path).apply { parentFile.mkdirs() }.writeText("// whose")
        listOf("a/src/A.kt", "a/b/src/B.java", "docs/x.md", "build.gradle", "a/build/C.kt", ".git/D.kt", "a/e.txt").forEach(::write)
        placesByModule(root, listOf("a", "a/b")).mapValues { (_, files) -> files.map { it.path } } shouldBe
            mapOf("." to listOf("build.gradle"), "a" to listOf("a/src/A.kt"), "a/b" to listOf("a/b/src/B.java"), "docs" to listOf("docs/x.md"))
        reportOf(placesByModule(root, listOf("a", "a/b"))).lines().first() shouldBe
            "a/b/src/B.java:1: “whose”; use “with” or a possessive."
    }
})
