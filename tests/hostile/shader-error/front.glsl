#error [31m ]0;owned <script>alert('atelier-hostile')</script> <img src=x onerror=alert(1)>
float hostile_number = <script>alert('atelier-hostile')</script>;
