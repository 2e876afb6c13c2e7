package badlog.site

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe
import java.nio.file.Path
import kotlin.io.path.readLines

/** Correct words that the dictionary lacks: names, units, words of robotics. One per line, in alphabetical order. */
private val WORDS = Path.of("words.txt").readLines().filter { it.isNotBlank() && !it.startsWith('#') }

@Tags("InCheck")
class SpellingSpec : FunSpec({
    val root = Path.of("../..").toRealPath()

    fun aspell(vararg arguments: String): Process = ProcessBuilder("aspell", "--lang=en_US", "--encoding=utf-8", *arguments).redirectErrorStream(true).start()

    val speller = runCatching { aspell("dump", "dicts").inputStream.reader().readText() }.getOrDefault("").lines().any { it == "en_US" }
    val enabled = if (speller || System.getenv("BADLOG_SPELLING") == "required") Enabled.enabled else Enabled.disabled("aspell and its English words are missing")

    /** Returns the words of [text] that are neither in the dictionary nor in the list of words. */
    fun misspelled(text: String): Set<String> {
        val program = aspell("--ignore=2", "list")
        program.outputStream.writer().use { it.write(text.replace('’', '\'')) }
        return program.inputStream.reader().readLines().map { it.removeSuffix("'s") }.filter { it.isNotEmpty() && it !in WORDS }.toSortedSet()
    }

    test("each word of the guides is in the dictionary or in words.txt").config(enabledOrReasonIf = { enabled }) {
        val reader = GuideReader(root, SitePlan(root))
        SitePlan(root).pages.keys.flatMap { path -> misspelled(reader.prose(path)).map { "$path: $it" } }.joinToString("\n") shouldBe ""
    }

    test("a misspelled word is found, a word of words.txt is not, and code is not read").config(enabledOrReasonIf = { enabled }) {
        misspelled("The roboRIO browns out when the voltge sags.") shouldContain "voltge"
        misspelled("The roboRIO browns out.") shouldNotContain "roboRIO"
    }

    test("the list of words is in alphabetical order, and has each word once") {
        WORDS.zip(WORDS.drop(1)).filter { (a, b) -> compareValuesBy(a, b, { it.lowercase() }, { it }) >= 0 }.shouldBeEmpty()
    }

    test("every word of the list is used somewhere in the guides") {
        val reader = GuideReader(root, SitePlan(root))
        val used = SitePlan(root).pages.keys.flatMap { path -> Regex("[\\p{L}']+").findAll(reader.prose(path).replace('’', '\'')).map { it.value.trim('\'').removeSuffix("'s") } }.toSet()
        WORDS.filter { it !in used }.joinToString("\n") shouldBe ""
    }
})
