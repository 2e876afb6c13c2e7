package badlog.cli.pack

import badlog.rules.pack.RulePack
import java.nio.file.Files
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.Path

/** Finds packs whose endings may have been left out. */
internal object PackPlace {
    /** Returns the pack that [typed] means: one whose name it begins, or itself. */
    fun existing(typed: Path): Path =
        listOf(RulePack.ENDING, RulePack.ZIP_ENDING).map { typed.with(it) }.firstOrNull { Files.exists(it, NOFOLLOW_LINKS) } ?: typed

    /** Returns the pack that [typed] means, or a new one, whose name has the ending with which it is used beside logs. */
    fun forWriting(typed: Path): Path = existing(typed).let { pack ->
        if (Files.exists(pack, NOFOLLOW_LINKS) || "$pack".endsWith(RulePack.ENDING)) pack else typed.with(RulePack.ENDING)
    }

    private fun Path.with(ending: String): Path = resolveSibling("$fileName$ending")
}
