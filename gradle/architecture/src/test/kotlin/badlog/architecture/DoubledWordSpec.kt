package badlog.architecture

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import java.io.File

/** Tests that no word was written twice by an automatic edit or by mistake. */
class DoubledWordSpec : FunSpec({
    test("no comment and no guide has the same word twice in a row") {
        val texts = sourcesUnder(ROOT).map { File(ROOT, it.path) }.filter { it.name != "DoubledWordSpec.kt" }.map { it to commentsIn(it.readText()) } +
            File(ROOT, "docs").walk().filter { it.extension == "md" }.map { it to proseIn(it.readText()) }
        texts.flatMap { (file, text) -> doubledIn(text).map { "${file.relativeTo(ROOT)}: $it" } }.shouldBeEmpty()
    }

    test("a doubled word is found across the lines of a comment, but not in code") {
        doubledIn(commentsIn("/**\n * Returns the\n * the start.\n */\nval the = the the")) shouldBe listOf("the the")
        doubledIn(commentsIn("// Returns Returns it.\nprivate val mutex: Mutex = Mutex Mutex")) shouldBe listOf("Returns Returns")
        doubledIn(proseIn("Write `it it` and\n```\nout out\n```\na Very very good log")) shouldBe emptyList()
    }
})

private val ROOT = File("../..").canonicalFile
private val COMMENT = Regex("""/\*\*?([\s\S]*?)\*/|//(.*)""")
private val STAR = Regex("""\n\s*\*\s?""")
private val CODE = Regex("""```[\s\S]*?```|`[^`\n]*`""")
private val DOUBLED = Regex("""(?<![\w.:/$-])([A-Za-z]{2,})\s+\1(?![\w.:/(-])""")

/** The first word after a tag of KDoc is often its name again. */
private val TAG = Regex("""@(?:param|property) \w+""")

private fun commentsIn(code: String) = COMMENT.findAll(code).joinToString("\n.\n") { (it.groupValues[1] + it.groupValues[2]).replace(STAR, " ").replace(TAG, ".") }.replace(CODE, "`")

private fun proseIn(guide: String) = guide.replace(CODE, "`").replace("\n\n", "\n.\n")

private fun doubledIn(text: String) = DOUBLED.findAll(text).map { it.value.replace(Regex("\\s+"), " ") }.filterNot { it in CORRECT_REPEATS }.toList()

/** Repeated words that are correct English. */
private val CORRECT_REPEATS = setOf("that that", "had had")
