# What `flipbook gallery` makes its page of. They are built into the program (app/gallery).
set(gallery_page_files
  page.html
  piece.html
  video.html
  picture.html
  figure.html
  scrubber.html
  command.html
  table.html
  page.css
  videos.js
  scrubber.js
  copy.js
)
