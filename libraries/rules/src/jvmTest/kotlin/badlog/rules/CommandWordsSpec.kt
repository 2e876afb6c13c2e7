package badlog.rules

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class CommandWordsSpec : FunSpec({
    test("words are split at spaces, but not in quotes") {
        commandWords("""python3  "C:\my tools\a.py" '{header}' x"y z" """) shouldBe
            listOf("python3", """C:\my tools\a.py""", "{header}", "xy z")
        commandWords("a ''") shouldBe listOf("a", "")
    }

    test("characters of a shell have no special meaning") {
        commandWords("a | b \$HOME;*") shouldBe listOf("a", "|", "b", "\$HOME;*")
    }

    test("an open quote and an empty command are refused") {
        shouldThrow<IllegalArgumentException> { commandWords("a 'b") }.message shouldBe
            "In the command “a 'b” a quote (') is never closed."
        shouldThrow<IllegalArgumentException> { commandWords("  ") }
    }
})
