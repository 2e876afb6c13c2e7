package badlog.html

import java.nio.file.Path

/**
 * The name by which [page] shows the file [video]: as seen from the folder of the page, in which the video is, or in a folder of that.
 *
 * @throws ExportException when the video is missing, or is elsewhere, where the page may not look for it.
 */
public fun videoFor(page: Path, video: Path): String {
    checkReadable(video)
    val file = video.toAbsolutePath().normalize()
    val folder = page.toAbsolutePath().normalize().parent
    if (file.startsWith(folder)) return folder.relativize(file).joinToString("/")
    throw ExportException.Unreadable(
        video,
        "$video is not in the folder of $page; move it there, or write the page to the folder of the video.",
    )
}
