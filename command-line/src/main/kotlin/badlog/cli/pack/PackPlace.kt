package badlog.cli.pack

import badlog.rules.pack.RulePack
import java.nio.file.Files
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.Path

/** Finds packs by names that may lack an ending. */
internal object PackPlace {
    /** Returns [typed] with the ending of an existing pack, otherwise unchanged. */
    fun existing(typed: Path): Path =
        listOf(RulePack.ENDING, RulePack.ZIP_ENDING).map { typed.with(it) }.firstOrNull { Files.exists(it, NOFOLLOW_LINKS) } ?: typed

    /** Returns the existing pack for [typed], or a new one with the ending of packs beside logs. */
    fun forWriting(typed: Path): Path = existing(typed).let { pack ->
        if (Files.exists(pack, NOFOLLOW_LINKS) || "$pack".endsWith(RulePack.ENDING)) pack else typed.with(RulePack.ENDING)
    }

    private fun Path.with(ending: String): Path = resolveSibling("$fileName$ending")
}
