package badlog.exporter

import java.nio.file.Path

/**
 * Returns the path of the file [video], relative to the folder of [page]. The video must be in that folder or below it.
 *
 * @throws ExportException if the video is missing, or is elsewhere, where the page's policy forbids it.
 */
fun videoFor(page: Path, video: Path): String {
    checkReadable(video)
    val file = video.toAbsolutePath().normalize()
    val folder = page.toAbsolutePath().normalize().parent
    if (file.startsWith(folder)) return folder.relativize(file).joinToString("/")
    throw ExportException.Unreadable(
        video,
        "$video is not in the folder of $page; move it there, or write the page to the folder of the video.",
    )
}
